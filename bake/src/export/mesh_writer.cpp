// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "mesh_writer.h"

#include <algorithm>
#include <cmath>

#include "skeleton_writer.h"
#include "transform.h"

namespace lithe::bake {

namespace {

/// The triangles of one part and the vertices they use, renumbered.
struct PartMesh {
  std::vector<uint32_t> vertices;  ///< indices into the model, ascending
  std::vector<uint32_t> corners;   ///< indices into vertices
};

PartMesh partMesh(const Model& model, uint32_t part) {
  PartMesh mesh;
  for (size_t i = 0; i < model.triangles.size(); ++i) {
    if (model.triangle_part[i] == part)
      mesh.corners.insert(mesh.corners.end(), model.triangles[i].begin(), model.triangles[i].end());
  }
  mesh.vertices = mesh.corners;
  std::sort(mesh.vertices.begin(), mesh.vertices.end());
  mesh.vertices.erase(std::unique(mesh.vertices.begin(), mesh.vertices.end()), mesh.vertices.end());
  for (uint32_t& corner : mesh.corners) {
    corner = static_cast<uint32_t>(std::lower_bound(mesh.vertices.begin(), mesh.vertices.end(), corner) -
                                   mesh.vertices.begin());
  }
  return mesh;
}

/// glTF wants unit vectors; one without a direction becomes `fallback`.
glm::dvec3 unit(const glm::dvec3& v, const glm::dvec3& fallback) {
  const double length = glm::length(v);
  return length > 0.0 && std::isfinite(length) ? v / length : fallback;
}

/// Collects the values of one attribute.
class Floats {
 public:
  template <int kSize>
  void add(const glm::vec<kSize, double>& v) {
    for (int i = 0; i < kSize; ++i) values_.push_back(static_cast<float>(v[i]));
  }
  operator std::span<const float>() const { return values_; }

 private:
  std::vector<float> values_;
};

/// Takes a part's vertices from bind space to the space they are written in: that of a rigid part's node, else bind
/// space.
class WrittenSpace {
 public:
  /// @param turned  what is written there is drawn mirrored
  WrittenSpace(const glm::dmat4& from_bind, bool turned)
      : from_bind_(from_bind),
        directions_(from_bind),
        normals_(glm::transpose(glm::inverse(glm::dmat3(from_bind)))),
        turned_(turned) {}

  glm::dvec3 position(const glm::vec3& p) const { return glm::dvec3(from_bind_ * glm::dvec4(p, 1.0)); }
  glm::dvec3 normal(const glm::vec3& n) const { return unit(normals_ * glm::dvec3(n), {0.0, 0.0, 1.0}); }
  glm::dvec4 tangent(const glm::vec4& t) const {
    const double handedness = (t.w < 0.0f) != turned_ ? -1.0 : 1.0;
    return {unit(directions_ * glm::dvec3(t), {1.0, 0.0, 0.0}), handedness};
  }
  /// Viewers turn the triangles of a mirrored node round; these are turned beforehand.
  bool turned() const { return turned_; }

 private:
  glm::dmat4 from_bind_;
  glm::dmat3 directions_, normals_;
  bool turned_;
};

glm::dmat4 restWorld(const Model& model, uint32_t node) {
  glm::dmat4 world(1.0);
  for (; node != kNone; node = model.nodes[node].parent) world = model.nodes[node].rest.matrix() * world;
  return world;
}

WrittenSpace writtenSpace(const Model& model, uint32_t part, const PartMesh& mesh) {
  const uint32_t node = model.parts[part].rigid_node;
  if (node == kNone) return {glm::dmat4(1.0), false};
  return {model.joints[model.skins[mesh.vertices.front()].joint[0]].inverse_bind, mirrors(restWorld(model, node))};
}

Json writeShape(const Model& model, const PartMesh& mesh, const WrittenSpace& space, GltfBuilder& gltf) {
  Floats positions, normals, tangents;
  for (const uint32_t vertex : mesh.vertices) {
    positions.add(space.position(model.positions[vertex]));
    if (model.attributes.normal) normals.add(space.normal(model.normals[vertex]));
    if (model.attributes.tangent) tangents.add(space.tangent(model.tangents[vertex]));
  }
  Json attributes;
  attributes["POSITION"] = gltf.addFloats(positions, "VEC3", ViewTarget::kVertices, true);
  if (model.attributes.normal) attributes["NORMAL"] = gltf.addFloats(normals, "VEC3", ViewTarget::kVertices);
  if (model.attributes.tangent) attributes["TANGENT"] = gltf.addFloats(tangents, "VEC4", ViewTarget::kVertices);
  return attributes;
}

template <typename Vector>
std::vector<float> gathered(const std::vector<Vector>& values, const PartMesh& mesh) {
  std::vector<float> floats;
  for (const uint32_t vertex : mesh.vertices) {
    for (int i = 0; i < Vector::length(); ++i) floats.push_back(values[vertex][i]);
  }
  return floats;
}

void writeUvsAndColors(const Model& model, const PartMesh& mesh, Json& attributes, GltfBuilder& gltf) {
  for (uint32_t set = 0; set < model.attributes.uv_sets; ++set) {
    attributes["TEXCOORD_" + std::to_string(set)] =
        gltf.addFloats(gathered(model.uvs[set], mesh), "VEC2", ViewTarget::kVertices);
  }
  for (uint32_t set = 0; set < model.attributes.color_sets; ++set) {
    attributes["COLOR_" + std::to_string(set)] =
        gltf.addFloats(gathered(model.colors[set], mesh), "VEC4", ViewTarget::kVertices);
  }
}

/// Weights that sum to one in floats stay as they are, to the bit.
std::array<float, kMaxImportedInfluences> normalizedWeights(const Skin& skin) {
  constexpr double kExact = 1e-7;
  double sum = 0.0;
  for (uint32_t k = 0; k < skin.count; ++k) sum += skin.weight[k];
  std::array<float, kMaxImportedInfluences> weights{};
  for (uint32_t k = 0; k < skin.count; ++k) {
    weights[k] = std::abs(sum - 1.0) <= kExact ? skin.weight[k] : static_cast<float>(skin.weight[k] / sum);
  }
  return weights;
}

void writeSkinAttributes(const Model& model, const PartMesh& mesh, Json& attributes, GltfBuilder& gltf) {
  uint32_t most = 0;
  for (const uint32_t vertex : mesh.vertices) most = std::max<uint32_t>(most, model.skins[vertex].count);
  for (uint32_t set = 0; 4 * set < std::max(most, 1u); ++set) {
    std::vector<uint16_t> joints;
    std::vector<float> weights;
    for (const uint32_t vertex : mesh.vertices) {
      const Skin& skin = model.skins[vertex];
      const std::array<float, kMaxImportedInfluences> normalized = normalizedWeights(skin);
      for (uint32_t k = 4 * set; k < 4 * set + 4; ++k) {
        joints.push_back(k < skin.count ? skin.joint[k] : 0);
        weights.push_back(normalized[k]);
      }
    }
    attributes["JOINTS_" + std::to_string(set)] = gltf.addJoints(joints, static_cast<uint32_t>(model.joints.size()));
    attributes["WEIGHTS_" + std::to_string(set)] = gltf.addFloats(weights, "VEC4", ViewTarget::kVertices);
  }
}

Json writePrimitive(const Model& model, uint32_t part, PartMesh mesh, const std::vector<uint32_t>& material_of,
                    GltfBuilder& gltf) {
  const WrittenSpace space = writtenSpace(model, part, mesh);
  if (space.turned()) {
    for (size_t i = 0; i < mesh.corners.size(); i += 3) std::swap(mesh.corners[i + 1], mesh.corners[i + 2]);
  }
  Json attributes = writeShape(model, mesh, space, gltf);
  writeUvsAndColors(model, mesh, attributes, gltf);
  if (model.parts[part].rigid_node == kNone) writeSkinAttributes(model, mesh, attributes, gltf);
  Json primitive = {{"attributes", std::move(attributes)}};
  primitive["indices"] = gltf.addIndices(mesh.corners, static_cast<uint32_t>(mesh.vertices.size()));
  const uint32_t material = model.parts[part].material;
  if (material < material_of.size()) primitive["material"] = material_of[material];
  return primitive;
}

/// Parts that become one mesh: skinned ones of one name, rigid ones of one node.
struct MeshParts {
  std::string name;
  uint32_t rigid_node = kNone;
  std::vector<uint32_t> parts;
};

std::vector<MeshParts> meshesOf(const Model& model) {
  std::vector<bool> has_triangle(model.parts.size(), false);
  for (const uint32_t part : model.triangle_part) has_triangle[part] = true;
  std::vector<MeshParts> meshes;
  for (uint32_t part = 0; part < model.parts.size(); ++part) {
    if (!has_triangle[part]) continue;
    const Part& p = model.parts[part];
    const auto same = std::find_if(meshes.begin(), meshes.end(), [&](const MeshParts& mesh) {
      return mesh.rigid_node == p.rigid_node && (p.rigid_node != kNone || mesh.name == p.name);
    });
    MeshParts& mesh = same != meshes.end() ? *same : meshes.emplace_back(MeshParts{p.name, p.rigid_node, {}});
    mesh.parts.push_back(part);
  }
  return meshes;
}

void showMesh(const MeshParts& parts, const std::string& name, uint32_t mesh, uint32_t skin, bool own_rigid_nodes,
              GltfBuilder& gltf) {
  if (parts.rigid_node == kNone) {
    appendSceneNode({{"name", name}, {"mesh", mesh}, {"skin", skin}}, gltf);
  } else if (own_rigid_nodes) {
    appendChildNode({{"name", name}, {"mesh", mesh}}, parts.rigid_node, gltf);
  } else {
    gltf.json["nodes"][parts.rigid_node]["mesh"] = mesh;
  }
}

}  // namespace

void writeMeshes(const Model& model, uint32_t skin, const std::vector<uint32_t>& material_of, const MeshNaming& naming,
                 GltfBuilder& gltf) {
  for (const MeshParts& parts : meshesOf(model)) {
    const std::string name = (parts.name.empty() ? "mesh" : parts.name) + naming.suffix;
    Json primitives = Json::array();
    for (const uint32_t part : parts.parts) {
      primitives.push_back(writePrimitive(model, part, partMesh(model, part), material_of, gltf));
    }
    const uint32_t mesh = gltf.append("meshes", {{"name", name}, {"primitives", std::move(primitives)}});
    showMesh(parts, name, mesh, skin, naming.own_rigid_nodes, gltf);
  }
}

bool hasSkinnedTriangle(const Model& model) {
  return std::any_of(model.triangle_part.begin(), model.triangle_part.end(),
                     [&](uint32_t part) { return model.parts[part].rigid_node == kNone; });
}

}  // namespace lithe::bake
