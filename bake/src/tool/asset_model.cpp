// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "asset_model.h"

#include <algorithm>

#include "float_vertices.h"

namespace lithe::tool {
namespace {

using bake::Model;
using Triangle = std::array<uint32_t, 3>;

// ---- The skeleton, parts and materials -----------------------------------------------------------------------------

bake::Node nodeOf(const lithe_node& node) {
  bake::Node result;
  result.name = node.name;
  result.parent = node.parent;
  for (int i = 0; i < 3; ++i) {
    result.rest.translation[i] = node.translation[i];
    result.rest.scale[i] = node.scale[i];
  }
  result.rest.rotation = {node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]};
  return result;
}

bake::Joint jointOf(const lithe_joint& joint) {
  bake::Joint result;
  result.node = joint.node;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) result.inverse_bind[column][row] = joint.inverse_bind[4 * row + column];
  }
  return result;
}

bake::Part partOf(const lithe_part& part, Model& model) {
  bake::Part result;
  result.name = part.name;
  result.rigid_node = part.rigid_node;
  result.material = part.material_index;
  if (part.material_index != LITHE_NO_INDEX) {
    if (model.materials.size() <= part.material_index) model.materials.resize(part.material_index + 1);
    model.materials[part.material_index] = part.material;
  }
  return result;
}

Model modelWithoutSurface(const Asset& asset) {
  static_assert(LITHE_NO_INDEX == bake::kNone);
  const lithe_asset_info& info = asset.info();
  Model model;
  for (uint32_t i = 0; i < info.node_count; ++i) model.nodes.push_back(nodeOf(asset.node(i)));
  for (uint32_t i = 0; i < info.joint_count; ++i) model.joints.push_back(jointOf(asset.joint(i)));
  for (uint32_t i = 0; i < info.part_count; ++i) model.parts.push_back(partOf(asset.part(i), model));
  model.attributes = {info.has_normals != 0, info.has_tangents != 0, info.uv_sets, info.color_sets};
  model.rest_diagonal = info.rest_diagonal;
  return model;
}

// ---- Vertices ------------------------------------------------------------------------------------------------------

bake::Skin skinOf(const FloatVertices& vertices, uint32_t vertex) {
  bake::Skin skin;
  for (uint32_t i = 0; i < vertices.influences(); ++i) {
    if (vertices.weight(vertex, i) <= 0) continue;
    skin.joint[skin.count] = vertices.joint(vertex, i);
    skin.weight[skin.count++] = vertices.weight(vertex, i);
  }
  return skin;
}

void appendVertex(Model& model, const FloatVertices& vertices, uint32_t vertex) {
  model.positions.push_back(vertices.position(vertex));
  if (model.attributes.normal) model.normals.push_back(vertices.normal(vertex));
  if (model.attributes.tangent) model.tangents.push_back(vertices.tangent(vertex));
  for (uint32_t set = 0; set < model.attributes.uv_sets; ++set) model.uvs[set].push_back(vertices.uv(vertex, set));
  for (uint32_t set = 0; set < model.attributes.color_sets; ++set)
    model.colors[set].push_back(vertices.color(vertex, set));
  model.skins.push_back(skinOf(vertices, vertex));
}

/// Takes over the vertices that triangles use, in ascending order, and numbers the triangles' corners accordingly.
void fillVertices(Model& model, const Asset& asset, uint32_t vertex_count) {
  const FloatVertices vertices(asset, vertex_count);
  std::vector<uint32_t> number(vertex_count, bake::kNone);
  for (const Triangle& triangle : model.triangles) {
    for (const uint32_t corner : triangle) number[corner] = 0;
  }
  uint32_t used = 0;
  for (uint32_t vertex = 0; vertex < vertex_count; ++vertex) {
    if (number[vertex] == bake::kNone) continue;
    number[vertex] = used++;
    appendVertex(model, vertices, vertex);
  }
  for (Triangle& triangle : model.triangles) {
    for (uint32_t& corner : triangle) corner = number[corner];
  }
}

// ---- A cut between levels ------------------------------------------------------------------------------------------

/// The cuts of a hierarchy by the number of its nodes that exist: nodes [0, limit) with limit - roots even, since
/// children come in pairs and in the order of their splits.
class Cuts {
 public:
  explicit Cuts(const Asset& asset) {
    lithe_asset_hierarchy(asset.get(), &hierarchy_);
    while (roots_ < hierarchy_.node_count && hierarchy_.node_parent[roots_] == LITHE_NO_INDEX) ++roots_;
  }

  uint32_t splits() const { return (hierarchy_.node_count - roots_) / 2; }

  /// The faces of the cut after `splits` splits, corners as wedges, equal ones once, in the order of the file.
  std::vector<Triangle> faces(uint32_t splits) const {
    const std::vector<uint32_t> wedge = ancestors(roots_ + 2 * splits);
    std::vector<Triangle> faces;
    for (uint32_t face = 0; face < hierarchy_.face_count; ++face) {
      const uint32_t* corner = hierarchy_.face_wedges + 3 * face;
      const Triangle triangle{wedge[corner[0]], wedge[corner[1]], wedge[corner[2]]};
      if (!collapsed(triangle)) faces.push_back(triangle);
    }
    dropEqual(faces);
    return faces;
  }

  uint32_t part(const Triangle& triangle) const { return hierarchy_.wedge_part[triangle[0]]; }

 private:
  /// For each wedge the one that stands for it while only nodes below `limit` exist.
  std::vector<uint32_t> ancestors(uint32_t limit) const {
    std::vector<uint32_t> wedge(hierarchy_.wedge_count);
    for (uint32_t w = 0; w < hierarchy_.wedge_count; ++w) {
      wedge[w] = hierarchy_.wedge_node[w] < limit ? w : wedge[hierarchy_.wedge_parent[w]];
    }
    return wedge;
  }

  uint32_t node(uint32_t wedge) const { return hierarchy_.wedge_node[wedge]; }

  bool collapsed(const Triangle& t) const {
    return node(t[0]) == node(t[1]) || node(t[1]) == node(t[2]) || node(t[2]) == node(t[0]);
  }

  /// The nodes of a face's corners, turned so that the smallest is first: equal for equal faces of the same
  /// orientation.
  Triangle key(const Triangle& t) const {
    Triangle nodes{node(t[0]), node(t[1]), node(t[2])};
    std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  void dropEqual(std::vector<Triangle>& faces) const {
    std::vector<std::pair<Triangle, uint32_t>> order(faces.size());
    for (uint32_t i = 0; i < faces.size(); ++i) order[i] = {key(faces[i]), i};
    std::sort(order.begin(), order.end());
    std::vector<bool> repeated(faces.size(), false);
    for (size_t i = 1; i < order.size(); ++i) repeated[order[i].second] = order[i].first == order[i - 1].first;
    size_t kept = 0;
    for (size_t i = 0; i < faces.size(); ++i) {
      if (!repeated[i]) faces[kept++] = faces[i];
    }
    faces.resize(kept);
  }

  lithe_hierarchy hierarchy_{};
  uint32_t roots_ = 0;
};

uint32_t distance(size_t count, uint32_t target) {
  return count > target ? static_cast<uint32_t>(count - target) : static_cast<uint32_t>(target - count);
}

/// The triangle count grows with the splits (but for a few faces that become equal), so halving finds the target.
std::vector<Triangle> facesNear(const Cuts& cuts, uint32_t target) {
  uint32_t low = 0, high = cuts.splits();
  std::vector<Triangle> best = cuts.faces(high);
  const auto better = [&](std::vector<Triangle> faces) {
    const size_t count = faces.size();
    if (distance(count, target) < distance(best.size(), target)) best = std::move(faces);
    return count;
  };
  better(cuts.faces(0));
  while (low < high) {
    const uint32_t middle = low + (high - low) / 2;
    if (better(cuts.faces(middle)) < target)
      low = middle + 1;
    else
      high = middle;
  }
  return best;
}

void fillTriangles(Model& model, std::vector<Triangle> faces, const Cuts& cuts) {
  std::stable_sort(faces.begin(), faces.end(),
                   [&](const Triangle& a, const Triangle& b) { return cuts.part(a) < cuts.part(b); });
  for (const Triangle& face : faces) model.triangle_part.push_back(cuts.part(face));
  model.triangles = std::move(faces);
}

}  // namespace

Model modelOfLevel(const Asset& asset, uint32_t level) {
  Model model = modelWithoutSurface(asset);
  LevelIndices indices = levelIndices(asset, level);
  model.triangles = std::move(indices.triangles);
  for (uint32_t part = 0; part < indices.ranges.size(); ++part) {
    model.triangle_part.insert(model.triangle_part.end(), indices.ranges[part].index_count / 3, part);
  }
  fillVertices(model, asset, asset.level(level).vertex_count);
  return model;
}

Model modelOfTriangles(const Asset& asset, uint32_t triangles) {
  const Cuts cuts(asset);
  Model model = modelWithoutSurface(asset);
  fillTriangles(model, facesNear(cuts, triangles), cuts);
  fillVertices(model, asset, asset.info().vertex_count);
  return model;
}

}  // namespace lithe::tool
