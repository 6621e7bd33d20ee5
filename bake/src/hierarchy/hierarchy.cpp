// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/hierarchy.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <string>

#include "attributes.h"
#include "lithe/format/octahedral.h"
#include "lithe/format/placement.h"

namespace lithe::bake {
namespace {

/// The mesh while its collapses are replayed: faces with the node and wedge of each corner, and the faces of each node.
class Replay {
 public:
  Replay(Hierarchy& hierarchy, int32_t normal_center)
      : h_(hierarchy), normal_center_(normal_center), face_wedges_(hierarchy.face_wedges) {
    node_faces_.resize(h_.vertex_count);
    for (uint32_t f = 0; f < face_wedges_.size(); ++f)
      for (uint32_t wedge : face_wedges_[f]) node_faces_[h_.wedge_node[wedge]].push_back(f);
    h_.birth_node.assign(face_wedges_.size(), kNone);
  }

  void collapse(uint32_t node) {
    const auto [a, b] = h_.children[node];
    beginClasses(a, b);
    std::vector<uint32_t> survivors = splitFaces(a, b, node);
    adoptOrphans(survivors, a, b);
    makeWedges(node);
    relabel(survivors, a, b);
    node_faces_[a] = {};
    node_faces_[b] = {};
    node_faces_.push_back(std::move(survivors));
  }

 private:
  // Wedges of the two children are numbered locally: a's first, then b's.
  void beginClasses(uint32_t a, uint32_t b) {
    first_[0] = h_.first_wedge[a];
    first_[1] = h_.first_wedge[b];
    count_[0] = h_.first_wedge[a + 1] - first_[0];
    count_[1] = h_.first_wedge[b + 1] - first_[1];
    class_of_.resize(count_[0] + count_[1]);
    for (uint32_t i = 0; i < class_of_.size(); ++i) class_of_[i] = i;
  }

  uint32_t local(uint32_t wedge) const {
    return wedge >= first_[0] && wedge < first_[0] + count_[0] ? wedge - first_[0] : count_[0] + wedge - first_[1];
  }
  uint32_t global(uint32_t index) const {
    return index < count_[0] ? first_[0] + index : first_[1] + index - count_[0];
  }
  uint32_t find(uint32_t i) const {
    while (class_of_[i] != i) i = class_of_[i];
    return i;
  }
  void unite(uint32_t i, uint32_t j) {
    i = find(i);
    j = find(j);
    class_of_[std::max(i, j)] = std::min(i, j);
  }

  // Faces at both children die and unite the wedges at their two corners; the others survive.
  std::vector<uint32_t> splitFaces(uint32_t a, uint32_t b, uint32_t node) {
    std::vector<uint32_t> survivors;
    births_ = 0;
    for (uint32_t f : node_faces_[a]) {
      uint32_t at_a = kNone, at_b = kNone;
      for (uint32_t wedge : face_wedges_[f]) {
        if (h_.wedge_node[wedge] == a) at_a = wedge;
        if (h_.wedge_node[wedge] == b) at_b = wedge;
      }
      if (at_b == kNone) {
        survivors.push_back(f);
      } else {
        unite(local(at_a), local(at_b));
        h_.birth_node[f] = node;
        ++births_;
      }
    }
    for (uint32_t f : node_faces_[b])
      if (h_.birth_node[f] == kNone) survivors.push_back(f);
    return survivors;
  }

  // A class that lost its last face would be carried to the root for nothing: it joins one of its part that is in use,
  // the one whose values are nearest.
  void adoptOrphans(const std::vector<uint32_t>& survivors, uint32_t a, uint32_t b) {
    std::vector<char> used(class_of_.size(), 0);
    for (uint32_t f : survivors)
      for (uint32_t wedge : face_wedges_[f])
        if (h_.wedge_node[wedge] == a || h_.wedge_node[wedge] == b) used[find(local(wedge))] = 1;
    for (uint32_t i = 0; i < class_of_.size(); ++i) {
      if (class_of_[i] != i || used[i]) continue;
      uint32_t host = kNone, least = 0;
      for (uint32_t j = 0; j < class_of_.size(); ++j) {
        if (class_of_[j] != j || j == i || h_.wedge_part[global(j)] != h_.wedge_part[global(i)]) continue;
        if (!used[j] && j > i) continue;
        const uint32_t bits = bitsApart(global(i), global(firstBeside(i, j)));
        if (host == kNone || bits < least) host = j, least = bits;
      }
      if (host == kNone) continue;
      const bool host_used = used[host];
      unite(i, host);
      used[find(i)] = host_used;
    }
  }

  // The first wedge of a class at the child that a wedge is at; of the class at all if it has none there.
  uint32_t firstBeside(uint32_t i, uint32_t host) const {
    const auto begin = i < count_[0] ? 0 : count_[0], end = begin + count_[i < count_[0] ? 0 : 1];
    for (uint32_t j = begin; j < end; ++j)
      if (find(j) == host) return j;
    return host;
  }

  // About what it costs to tell a wedge's values from another's.
  uint32_t bitsApart(uint32_t wedge, uint32_t other) const {
    const int32_t* a = h_.wedge_attributes.data() + size_t{wedge} * h_.record.stride;
    const int32_t* b = h_.wedge_attributes.data() + size_t{other} * h_.record.stride;
    uint32_t bits = 0;
    for (uint32_t v = 0; v < h_.record.stride; ++v)
      bits += static_cast<uint32_t>(std::bit_width(static_cast<uint32_t>(std::abs(a[v] - b[v]))));
    return bits;
  }

  void makeWedges(uint32_t node) {
    new_wedge_.assign(class_of_.size(), kNone);
    for (uint32_t i = 0; i < class_of_.size(); ++i)
      if (class_of_[i] == i) new_wedge_[i] = addWedge(node, i);
    for (uint32_t i = 0; i < class_of_.size(); ++i) h_.wedge_parent[global(i)] = new_wedge_[find(i)];
    h_.first_wedge.push_back(static_cast<uint32_t>(h_.wedge_node.size()));
  }

  // The parent wedge lies between the first members on either side; a class of one child keeps its values.
  uint32_t addWedge(uint32_t node, uint32_t representative) {
    uint32_t member[2] = {kNone, kNone};
    for (uint32_t i = 0; i < class_of_.size(); ++i)
      if (find(i) == representative) {
        uint32_t& first = member[i < count_[0] ? 0 : 1];
        if (first == kNone) first = global(i);
      }
    const uint32_t wedge = static_cast<uint32_t>(h_.wedge_node.size());
    h_.wedge_node.push_back(node);
    h_.wedge_parent.push_back(kNone);
    h_.wedge_part.push_back(h_.wedge_part[global(representative)]);
    const uint32_t stride = h_.record.stride;
    h_.wedge_attributes.resize(h_.wedge_attributes.size() + stride);
    const uint32_t from = member[0] != kNone ? member[0] : member[1];
    const uint32_t to = member[1] != kNone ? member[1] : member[0];
    int32_t* const base = h_.wedge_attributes.data();
    attributesBetween(h_.record, base + size_t{from} * stride, base + size_t{to} * stride,
                      {normal_center_, h_.t8[node], births_ > 0}, base + size_t{wedge} * stride);
    return wedge;
  }

  void relabel(const std::vector<uint32_t>& survivors, uint32_t a, uint32_t b) {
    for (uint32_t f : survivors)
      for (uint32_t& wedge : face_wedges_[f])
        if (h_.wedge_node[wedge] == a || h_.wedge_node[wedge] == b) wedge = h_.wedge_parent[wedge];
  }

  Hierarchy& h_;
  const int32_t normal_center_;
  std::vector<std::array<uint32_t, 3>> face_wedges_;
  std::vector<std::vector<uint32_t>> node_faces_;
  uint32_t first_[2] = {0, 0}, count_[2] = {0, 0};
  uint32_t births_ = 0;  // faces that the split of the node at hand makes
  std::vector<uint32_t> class_of_, new_wedge_;
};

void addLeaves(const Mesh& mesh, Hierarchy& h) {
  const uint32_t vertices = mesh.vertexCount();
  h.vertex_count = vertices;
  h.parent.assign(vertices, kNone);
  h.children.assign(vertices, {kNone, kNone});
  h.t8.assign(vertices, 0);
  h.position = mesh.positions;
  h.skin = mesh.skins;
}

// Wedges of a vertex must be consecutive: the mesh's wedges are renumbered by vertex, in their order.
void addLeafWedges(const Mesh& mesh, Hierarchy& h) {
  const uint32_t wedges = mesh.wedgeCount();
  h.first_wedge.assign(mesh.vertexCount() + 1, 0);
  for (uint32_t w = 0; w < wedges; ++w) ++h.first_wedge[mesh.wedge_vertex[w] + 1];
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) h.first_wedge[v + 1] += h.first_wedge[v];
  std::vector<uint32_t> renumbered(wedges), next(h.first_wedge.begin(), h.first_wedge.end() - 1);
  for (uint32_t w = 0; w < wedges; ++w) renumbered[w] = next[mesh.wedge_vertex[w]]++;
  h.wedge_node.resize(wedges);
  h.wedge_part.resize(wedges);
  h.wedge_parent.assign(wedges, kNone);
  h.wedge_attributes.resize(size_t{wedges} * h.record.stride);
  for (uint32_t w = 0; w < wedges; ++w) {
    h.wedge_node[renumbered[w]] = mesh.wedge_vertex[w];
    h.wedge_part[renumbered[w]] = mesh.wedge_part[w];
    gatherAttributes(mesh, w, h.record, h.wedge_attributes.data() + size_t{renumbered[w]} * h.record.stride);
  }
  h.face_wedges = mesh.triangles;
  for (auto& triangle : h.face_wedges)
    for (uint32_t& wedge : triangle) wedge = renumbered[wedge];
}

void checkCollapse(const Hierarchy& h, const Collapse& c, uint32_t index, uint32_t placement_shift) {
  const std::string where = "collapse " + std::to_string(index) + ": ";
  for (uint32_t child : c.child)
    if (child >= h.nodeCount() || h.parent[child] != kNone) throw Error(where + "names a node that is not in the cut");
  if (c.child[0] == c.child[1] || c.t8 > 8) throw Error(where + "merges a node with itself or has no valid t8");
  const glm::ivec3 v = h.position[c.child[0]], d = h.position[c.child[1]] - v;
  const format::Int3 difference{d.x, d.y, d.z};
  const format::Int3 centre = format::pointBetween({v.x, v.y, v.z}, difference, c.t8);
  const int32_t step = format::latticeStep(difference, placement_shift);
  if ((c.position.x - centre.x) % step || (c.position.y - centre.y) % step || (c.position.z - centre.z) % step)
    throw Error(where + "puts the parent off its lattice");
}

void addParent(Hierarchy& h, const Collapse& c) {
  const uint32_t node = h.nodeCount();
  h.parent.push_back(kNone);
  h.children.push_back({c.child[0], c.child[1]});
  h.t8.push_back(c.t8);
  h.position.push_back(c.position);
  h.skin.push_back(c.skin);
  h.parent[c.child[0]] = h.parent[c.child[1]] = node;
}

// Numbers the leaves depth first so that "is below" is one comparison of intervals.
void numberLeaves(Hierarchy& h) {
  h.leaves.assign(h.nodeCount(), {0, 0});
  std::vector<uint32_t> leaf_count(h.nodeCount(), 1);
  for (uint32_t n = h.vertex_count; n < h.nodeCount(); ++n)
    leaf_count[n] = leaf_count[h.children[n][0]] + leaf_count[h.children[n][1]];
  uint32_t next = 0;
  for (uint32_t n = h.nodeCount(); n-- > 0;) {
    if (h.parent[n] == kNone) {
      h.leaves[n] = {next, next + leaf_count[n]};
      next += leaf_count[n];
    }
    if (h.isLeaf(n)) continue;
    const uint32_t middle = h.leaves[n][0] + leaf_count[h.children[n][0]];
    h.leaves[h.children[n][0]] = {h.leaves[n][0], middle};
    h.leaves[h.children[n][1]] = {middle, h.leaves[n][1]};
  }
}

void listBirths(Hierarchy& h) {
  h.born_begin.assign(h.nodeCount() + 1, 0);
  for (uint32_t node : h.birth_node)
    if (node != kNone) ++h.born_begin[node + 1];
  for (uint32_t n = 0; n < h.nodeCount(); ++n) h.born_begin[n + 1] += h.born_begin[n];
  h.born.resize(h.born_begin.back());
  std::vector<uint32_t> next(h.born_begin.begin(), h.born_begin.end() - 1);
  for (uint32_t f = 0; f < h.birth_node.size(); ++f)
    if (h.birth_node[f] != kNone) h.born[next[h.birth_node[f]]++] = f;
}

}  // namespace

Hierarchy buildHierarchy(const Mesh& mesh, const CollapseSequence& sequence, uint32_t placement_shift) {
  Hierarchy h;
  h.record = wedgeRecord(mesh.attributes);
  addLeaves(mesh, h);
  addLeafWedges(mesh, h);
  Replay replay(h, format::octahedralCenter(mesh.normal_bits));
  for (uint32_t i = 0; i < sequence.collapses.size(); ++i) {
    checkCollapse(h, sequence.collapses[i], i, placement_shift);
    addParent(h, sequence.collapses[i]);
    replay.collapse(h.nodeCount() - 1);
  }
  numberLeaves(h);
  listBirths(h);
  return h;
}

}  // namespace lithe::bake
