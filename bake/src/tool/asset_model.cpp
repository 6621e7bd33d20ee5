// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "asset_model.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace lithe::tool {
namespace {

using bake::Model;
using Triangle = std::array<uint32_t, 3>;

void require(lithe_result result) {
  if (result != LITHE_OK) throw std::logic_error(std::string("the runtime answered ") + lithe_result_name(result));
}

// ---- The skeleton, parts and materials
// ---------------------------------------------------------------------------------

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

// ---- Vertices
// ----------------------------------------------------------------------------------------------------------

/// Everything as floats, one after the other: the layout in which nothing is lost on the way.
struct FloatLayout {
  lithe_vertex_layout layout{};
  uint32_t influences = 0;

  explicit FloatLayout(const lithe_asset_info& info) : influences(info.max_influences) {
    layout.struct_size = sizeof layout;
    layout.influences = influences;
    layout.position = floats(3);
    if (info.has_normals) layout.normal = floats(3);
    if (info.has_tangents) layout.tangent = floats(4);
    for (uint32_t set = 0; set < info.uv_sets; ++set) layout.uv[set] = floats(2);
    for (uint32_t set = 0; set < info.color_sets; ++set) layout.color[set] = floats(4);
    layout.weights = floats(influences);
    layout.joints = {LITHE_FORMAT_U16, static_cast<uint16_t>(layout.stride)};
    layout.stride += (2 * influences + 3) / 4 * 4;
  }

 private:
  lithe_attribute floats(uint32_t count) {
    const lithe_attribute attribute{LITHE_FORMAT_F32, static_cast<uint16_t>(layout.stride)};
    layout.stride += 4 * count;
    return attribute;
  }
};

template <typename Value>
Value read(const uint8_t* vertex, lithe_attribute attribute) {
  Value value;
  std::memcpy(&value, vertex + attribute.offset, sizeof value);
  return value;
}

bake::Skin skinOf(const uint8_t* vertex, const FloatLayout& format) {
  bake::Skin skin;
  for (uint32_t i = 0; i < format.influences; ++i) {
    float weight;
    uint16_t joint;
    std::memcpy(&weight, vertex + format.layout.weights.offset + 4 * i, sizeof weight);
    std::memcpy(&joint, vertex + format.layout.joints.offset + 2 * i, sizeof joint);
    if (weight <= 0) continue;
    skin.joint[skin.count] = joint;
    skin.weight[skin.count++] = weight;
  }
  return skin;
}

void appendVertex(Model& model, const uint8_t* vertex, const FloatLayout& format) {
  const lithe_vertex_layout& layout = format.layout;
  model.positions.push_back(read<glm::vec3>(vertex, layout.position));
  if (model.attributes.normal) model.normals.push_back(read<glm::vec3>(vertex, layout.normal));
  if (model.attributes.tangent) model.tangents.push_back(read<glm::vec4>(vertex, layout.tangent));
  for (uint32_t set = 0; set < model.attributes.uv_sets; ++set) {
    model.uvs[set].push_back(read<glm::vec2>(vertex, layout.uv[set]));
  }
  for (uint32_t set = 0; set < model.attributes.color_sets; ++set) {
    model.colors[set].push_back(read<glm::vec4>(vertex, layout.color[set]));
  }
  model.skins.push_back(skinOf(vertex, format));
}

/// Takes over the vertices that triangles use, in ascending order, and numbers the triangles' corners accordingly.
void fillVertices(Model& model, const Asset& asset, uint32_t vertex_count) {
  const FloatLayout format(asset.info());
  std::vector<uint8_t> vertices(static_cast<size_t>(vertex_count) * format.layout.stride);
  require(lithe_asset_write_vertices(asset.get(), &format.layout, 0, vertex_count, vertices.data(), vertices.size()));
  std::vector<uint32_t> number(vertex_count, bake::kNone);
  for (const Triangle& triangle : model.triangles) {
    for (const uint32_t corner : triangle) number[corner] = 0;
  }
  uint32_t used = 0;
  for (uint32_t vertex = 0; vertex < vertex_count; ++vertex) {
    if (number[vertex] == bake::kNone) continue;
    number[vertex] = used++;
    appendVertex(model, vertices.data() + static_cast<size_t>(vertex) * format.layout.stride, format);
  }
  for (Triangle& triangle : model.triangles) {
    for (uint32_t& corner : triangle) corner = number[corner];
  }
}

// ---- A cut between levels
// ----------------------------------------------------------------------------------------------

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
  const lithe_level record = asset.level(level);
  std::vector<lithe_range> ranges(asset.info().part_count);
  model.triangles.resize(record.triangle_count);
  require(lithe_asset_write_indices(asset.get(), level, LITHE_INDEX_U32, model.triangles.data(),
                                    model.triangles.size() * sizeof(Triangle), ranges.data()));
  for (uint32_t part = 0; part < ranges.size(); ++part) {
    model.triangle_part.insert(model.triangle_part.end(), ranges[part].index_count / 3, part);
  }
  fillVertices(model, asset, record.vertex_count);
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
