// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "asset_model.h"

#include <algorithm>

#include "asset_cut.h"
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

void fillTriangles(Model& model, std::vector<CutFace> faces, const Cuts& cuts) {
  std::stable_sort(faces.begin(), faces.end(),
                   [&](const CutFace& a, const CutFace& b) { return cuts.part(a) < cuts.part(b); });
  for (const CutFace& face : faces) model.triangle_part.push_back(cuts.part(face));
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

Model modelOfAllVertices(const Asset& asset) {
  Model model = modelWithoutSurface(asset);
  const FloatVertices vertices(asset, asset.info().vertex_count);
  for (uint32_t vertex = 0; vertex < vertices.count(); ++vertex) appendVertex(model, vertices, vertex);
  return model;
}

Model modelOfTriangles(const Asset& asset, uint32_t triangles) {
  const Cuts cuts(asset);
  Model model = modelWithoutSurface(asset);
  fillTriangles(model, cuts.facesNear(triangles), cuts);
  fillVertices(model, asset, asset.info().vertex_count);
  return model;
}

}  // namespace lithe::tool
