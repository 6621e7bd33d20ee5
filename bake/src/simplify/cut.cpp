// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/cut.h"

#include <algorithm>
#include <set>

#include "wedge_replay.h"

namespace lithe::bake {

namespace {

/// Everything but the vertices and triangles.
Model skeletonOf(const Model& original, const Mesh& mesh) {
  Model model;
  model.nodes = original.nodes;
  model.joints = original.joints;
  model.materials = original.materials;
  model.parts = original.parts;
  model.clips = original.clips;
  model.rest_diagonal = original.rest_diagonal;
  model.attributes = mesh.attributes;
  return model;
}

/// The nodes' corners of a triangle from the smallest on: equal for equal triangles of equal orientation.
std::array<uint32_t, 3> orientedNodes(const ReplayFace& face) {
  std::array<uint32_t, 3> nodes = face.node;
  std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void appendVertex(const Mesh& mesh, const CollapseSequence& sequence, const WedgeValue& value, uint32_t part,
                  uint32_t node, Model& model) {
  const uint32_t vertices = mesh.vertexCount();
  const Collapse* collapse = node < vertices ? nullptr : &sequence.collapses[node - vertices];
  const glm::ivec3 position = collapse ? collapse->position : mesh.positions[node];
  model.positions.emplace_back(mesh.grid.origin + mesh.grid.step * glm::dvec3(position));
  model.skins.push_back(toFloats(collapse ? collapse->skin : mesh.skins[node], mesh.weight_one));
  if (mesh.attributes.normal) model.normals.push_back(value.normal);
  if (mesh.attributes.tangent) model.tangents.push_back(value.tangent);
  for (uint32_t set = 0; set < mesh.attributes.uv_sets; ++set) {
    const UvGrid& grid = mesh.part_uv[part][set];
    model.uvs[set].emplace_back(grid.offset + grid.scale * glm::dvec2(value.uv[set]));
  }
  for (uint32_t set = 0; set < mesh.attributes.color_sets; ++set) {
    model.colors[set].emplace_back(glm::dvec4(value.color[set]) / 255.0);
  }
}

}  // namespace

Skin toFloats(const QuantizedSkin& quantized, uint32_t weight_one) {
  Skin skin;
  skin.count = quantized.count;
  for (uint32_t k = 0; k < quantized.count; ++k) {
    skin.joint[k] = quantized.joint[k];
    skin.weight[k] = static_cast<float>(quantized.weight[k] / double(weight_one));
  }
  return skin;
}

uint32_t collapsesToReach(const CollapseSequence& sequence, const Mesh& mesh, uint32_t triangles) {
  if (mesh.triangleCount() <= triangles) return 0;
  uint32_t count = 0;
  while (count < sequence.collapses.size() && (count == 0 || sequence.collapses[count - 1].triangles > triangles))
    ++count;
  // The absorptions that end a level belong to it: they leave the triangles as they are.
  while (count > 0 && count < sequence.collapses.size() &&
         sequence.collapses[count].triangles == sequence.collapses[count - 1].triangles)
    ++count;
  return count;
}

Model cutToModel(const Model& original, const Mesh& mesh, const CollapseSequence& sequence, uint32_t triangles) {
  WedgeReplay replay(mesh);
  const uint32_t count = collapsesToReach(sequence, mesh, triangles);
  for (uint32_t i = 0; i < count; ++i) replay.collapse(mesh.vertexCount() + i, sequence.collapses[i]);

  Model model = skeletonOf(original, mesh);
  std::vector<uint32_t> vertex_of(replay.wedgeCount(), kNone);
  std::set<std::array<uint32_t, 3>> seen;
  for (const ReplayFace& face : replay.faces()) {
    if (!face.alive() || !seen.insert(orientedNodes(face)).second) continue;
    std::array<uint32_t, 3> triangle;
    for (uint32_t k = 0; k < 3; ++k) {
      uint32_t& vertex = vertex_of[face.wedge[k]];
      if (vertex == kNone) {
        vertex = static_cast<uint32_t>(model.positions.size());
        appendVertex(mesh, sequence, replay.value(face.wedge[k]), face.part, face.node[k], model);
      }
      triangle[k] = vertex;
    }
    model.triangles.push_back(triangle);
    model.triangle_part.push_back(face.part);
  }
  return model;
}

}  // namespace lithe::bake
