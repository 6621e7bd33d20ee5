// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "geometry.h"

#include <algorithm>
#include <cmath>

#include "box.h"
#include "influences.h"

namespace lithe::bake {

namespace {

/// The vertices that triangles refer to, ascending.
std::vector<uint32_t> usedVertices(const std::vector<Triangle>& triangles) {
  std::vector<uint32_t> used;
  used.reserve(triangles.size() * 3);
  for (const Triangle& triangle : triangles) used.insert(used.end(), triangle.begin(), triangle.end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

class GeometryReader {
 public:
  GeometryReader(const GltfFile& file, const Inventory& inventory) : file_(file), inventory_(inventory) {
    draft_.model.attributes = inventory.attributes;
    for (const auto& material : file.document.materials) draft_.model.materials.push_back(material.name);
    skin_joints_.resize(file.document.skins.size());
    rigid_joint_.resize(file.document.nodes.size(), kNone);
  }

  Draft read() {
    for (const PrimitiveUse& use : inventory_.uses) append(use);
    repairs_.addTo(draft_.model.warnings);
    draft_.model.rest_diagonal = (any_skinned_ ? skinned_box_ : rigid_box_).diagonal();
    return std::move(draft_);
  }

 private:
  void append(const PrimitiveUse& use);
  void addPart(const PrimitiveUse& use);
  void checkProportion(uint64_t vertices, uint64_t triangles) const;
  void addTriangles(const std::vector<Triangle>& triangles, const std::vector<uint32_t>& used);
  void addPositions(const AccessorView& positions, const std::vector<uint32_t>& used, const PrimitiveUse& use);
  void addDirections(const PrimitiveArrays& arrays, const std::vector<uint32_t>& used);
  void addUvs(const PrimitiveArrays& arrays, const std::vector<uint32_t>& used, const std::string& place);
  void addColors(const PrimitiveArrays& arrays, const std::vector<uint32_t>& used, const std::string& place);
  void addSkins(const PrimitiveArrays& arrays, const std::vector<uint32_t>& used, const PrimitiveUse& use);
  JointRange jointsOfSkin(uint32_t skin);
  std::vector<glm::dmat4> inverseBinds(uint32_t skin, const std::string& skin_place) const;
  uint32_t jointOfRigidNode(uint32_t node);
  float checked(double value, uint32_t vertex, const std::string& place) const;

  const GltfFile& file_;
  const Inventory& inventory_;
  Draft draft_;
  SkinRepairs repairs_;
  std::vector<JointRange> skin_joints_;  // count 0: not read yet
  std::vector<uint32_t> rigid_joint_;    // per node of the file
  std::map<int, Box> boxes_;             // per position accessor
  Box skinned_box_, rigid_box_;
  bool any_skinned_ = false;
};

void GeometryReader::append(const PrimitiveUse& use) {
  const std::string place = primitivePlace(file_, use);
  const PrimitiveArrays arrays(file_, use);
  const AccessorView positions = *arrays.attribute("POSITION", {TINYGLTF_TYPE_VEC3});
  const std::vector<Triangle> triangles = arrays.triangles();
  if (triangles.empty()) {
    draft_.model.warnings.push_back(place + ": it has no triangles and is left out");
    return;
  }
  const std::vector<uint32_t> used = usedVertices(triangles);
  checkProportion(used.size(), triangles.size());
  addPart(use);
  addTriangles(triangles, used);
  addPositions(positions, used, use);
  addDirections(arrays, used);
  addUvs(arrays, used, place);
  addColors(arrays, used, place);
  addSkins(arrays, used, use);
}

void GeometryReader::addPart(const PrimitiveUse& use) {
  const tinygltf::Primitive& primitive = primitiveOf(file_, use);
  const std::string& mesh_name = file_.document.meshes[use.mesh].name;
  if (primitive.material >= static_cast<int>(file_.document.materials.size())) {
    file_.name.fail(primitivePlace(file_, use),
                    "there is no material " + std::to_string(primitive.material) + "; re-export the file");
  }
  Part part;
  part.name = mesh_name.empty() ? file_.document.nodes[use.node].name : mesh_name;
  part.material = primitive.material < 0 ? kNone : static_cast<uint32_t>(primitive.material);
  part.rigid_node = use.skinned ? kNone : use.node;  // the file's index until the model has nodes
  part.source_mesh = use.mesh;
  part.source_primitive = use.primitive;
  draft_.model.parts.push_back(std::move(part));
  draft_.part_node.push_back(use.node);
}

void GeometryReader::checkProportion(uint64_t vertices, uint64_t triangles) const {
  const uint64_t limit = file_.elementLimit();
  if (draft_.model.positions.size() + vertices > limit || draft_.model.triangles.size() + triangles > limit) {
    file_.name.fail("", "its nodes show its meshes so often that more than " + std::to_string(limit) +
                            " vertices or triangles result; bake one character at a time");
  }
}

void GeometryReader::addTriangles(const std::vector<Triangle>& triangles, const std::vector<uint32_t>& used) {
  Model& model = draft_.model;
  const uint32_t first = static_cast<uint32_t>(model.positions.size());
  const uint32_t part = static_cast<uint32_t>(model.parts.size() - 1);
  for (Triangle triangle : triangles) {
    for (uint32_t& corner : triangle) {
      corner = first + static_cast<uint32_t>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
    }
    model.triangles.push_back(triangle);
  }
  model.triangle_part.resize(model.triangles.size(), part);
}

float GeometryReader::checked(double value, uint32_t vertex, const std::string& place) const {
  const float rounded = static_cast<float>(value);
  if (!std::isfinite(rounded)) {
    file_.name.fail(place,
                    "a value of vertex " + std::to_string(vertex) + " is not a finite number; re-export the file");
  }
  return rounded;
}

/// The box is over the whole array, triangles or not: the unit of errors must not depend on what this import leaves
/// out.
void GeometryReader::addPositions(const AccessorView& positions, const std::vector<uint32_t>& used,
                                  const PrimitiveUse& use) {
  const std::string place = primitivePlace(file_, use) + ", POSITION";
  const auto position = [&](uint32_t vertex) {
    glm::vec3 p;
    for (uint32_t k = 0; k < 3; ++k) p[static_cast<int>(k)] = checked(positions.number(vertex, k), vertex, place);
    return p;
  };
  const auto [box, first_use] = boxes_.try_emplace(primitiveOf(file_, use).attributes.at("POSITION"));
  if (first_use) {
    for (uint32_t v = 0; v < positions.count(); ++v) box->second.add(glm::dvec3(position(v)));
  }
  Box& total = use.skinned ? skinned_box_ : rigid_box_;
  total.add(box->second.low);
  total.add(box->second.high);
  any_skinned_ = any_skinned_ || use.skinned;
  for (const uint32_t v : used) draft_.model.positions.push_back(position(v));
}

/// Directions are not checked: what is no direction is replaced by one that fits the surface.
void GeometryReader::addDirections(const PrimitiveArrays& arrays, const std::vector<uint32_t>& used) {
  Model& model = draft_.model;
  const auto normals = arrays.attribute("NORMAL", {TINYGLTF_TYPE_VEC3});
  const auto tangents = arrays.attribute("TANGENT", {TINYGLTF_TYPE_VEC4});
  const auto direction = [](const AccessorView& view, uint32_t vertex) {
    return glm::vec3(view.number(vertex, 0), view.number(vertex, 1), view.number(vertex, 2));
  };
  for (const uint32_t v : used) {
    model.normals.push_back(normals ? direction(*normals, v) : glm::vec3(0.0f));
    if (!model.attributes.tangent) continue;
    const float hand = tangents && tangents->number(v, 3) < 0.0 ? -1.0f : 1.0f;
    model.tangents.emplace_back(tangents ? direction(*tangents, v) : glm::vec3(0.0f), hand);
  }
}

void GeometryReader::addUvs(const PrimitiveArrays& arrays, const std::vector<uint32_t>& used,
                            const std::string& place) {
  for (uint32_t set = 0; set < draft_.model.attributes.uv_sets; ++set) {
    std::vector<glm::vec2>& uvs = draft_.model.uvs[set];
    const std::string name = attributeName("TEXCOORD", set);
    const auto view = arrays.attribute(name, {TINYGLTF_TYPE_VEC2});
    const std::string where = place + ", " + name;
    for (const uint32_t v : used) {
      uvs.push_back(view ? glm::vec2(checked(view->number(v, 0), v, where), checked(view->number(v, 1), v, where))
                         : glm::vec2(0.0f));
    }
  }
}

void GeometryReader::addColors(const PrimitiveArrays& arrays, const std::vector<uint32_t>& used,
                               const std::string& place) {
  for (uint32_t set = 0; set < draft_.model.attributes.color_sets; ++set) {
    std::vector<glm::vec4>& colors = draft_.model.colors[set];
    const std::string name = attributeName("COLOR", set);
    const auto view = arrays.attribute(name, {TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4});
    for (const uint32_t v : used) {
      glm::vec4 color(1.0f);
      for (uint32_t k = 0; view && k < view->components(); ++k) {
        color[static_cast<int>(k)] = checked(view->number(v, k, IntegerMeaning::kNormalized), v, place + ", " + name);
      }
      colors.push_back(glm::clamp(color, 0.0f, 1.0f));
    }
  }
}

void GeometryReader::addSkins(const PrimitiveArrays& arrays, const std::vector<uint32_t>& used,
                              const PrimitiveUse& use) {
  if (!use.skinned) {
    FileSkin skin;
    skin.count = 1;
    skin.joint[0] = jointOfRigidNode(use.node);
    skin.weight[0] = 1.0f;
    draft_.skins.insert(draft_.skins.end(), used.size(), skin);
    return;
  }
  const JointRange joints = jointsOfSkin(static_cast<uint32_t>(file_.document.nodes[use.node].skin));
  const InfluenceArrays influences(file_, arrays, joints, primitivePlace(file_, use) + ", WEIGHTS");
  for (const uint32_t v : used) draft_.skins.push_back(influences.read(v, repairs_));
}

uint32_t GeometryReader::jointOfRigidNode(uint32_t node) {
  if (rigid_joint_[node] == kNone) {
    rigid_joint_[node] = static_cast<uint32_t>(draft_.joints.size());
    draft_.joints.push_back({node, glm::dmat4(1.0), kNone});
  }
  return rigid_joint_[node];
}

JointRange GeometryReader::jointsOfSkin(uint32_t skin) {
  if (skin_joints_[skin].count != 0) return skin_joints_[skin];
  const std::vector<int>& nodes = file_.document.skins[skin].joints;
  const std::string place = "skin " + std::to_string(skin);
  if (nodes.empty()) file_.name.fail(place, "it has no joints; re-export the file");
  const std::vector<glm::dmat4> binds = inverseBinds(skin, place);
  skin_joints_[skin] = {static_cast<uint32_t>(draft_.joints.size()), static_cast<uint32_t>(nodes.size())};
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] < 0 || static_cast<size_t>(nodes[i]) >= file_.document.nodes.size()) {
      file_.name.fail(place, "there is no node " + std::to_string(nodes[i]) + "; re-export the file");
    }
    draft_.joints.push_back({static_cast<uint32_t>(nodes[i]), binds[i], skin});
  }
  return skin_joints_[skin];
}

/// One matrix per joint; identity where the skin states none.
std::vector<glm::dmat4> GeometryReader::inverseBinds(uint32_t skin, const std::string& skin_place) const {
  const tinygltf::Skin& stated = file_.document.skins[skin];
  std::vector<glm::dmat4> binds(stated.joints.size(), glm::dmat4(1.0));
  if (stated.inverseBindMatrices < 0) return binds;
  const std::string place = skin_place + ", inverse bind matrices";
  const AccessorView view = AccessorView::open(file_, stated.inverseBindMatrices, {TINYGLTF_TYPE_MAT4}, place);
  if (view.count() < binds.size()) {
    file_.name.fail(skin_place, "it has " + std::to_string(view.count()) + " inverse bind matrices for " +
                                    std::to_string(binds.size()) + " joints; re-export the file");
  }
  for (uint32_t i = 0; i < binds.size(); ++i) {
    for (int column = 0; column < 4; ++column) {
      // The last row is that of an affine matrix, whatever the file says.
      for (int row = 0; row < 3; ++row) {
        const double entry = view.number(i, static_cast<uint32_t>(column * 4 + row));
        if (!std::isfinite(entry)) {
          file_.name.fail(place, "matrix " + std::to_string(i) + " has an entry that is no number; re-export the file");
        }
        binds[i][column][row] = entry;
      }
    }
  }
  return binds;
}

}  // namespace

Draft readGeometry(const GltfFile& file, const Inventory& inventory) { return GeometryReader(file, inventory).read(); }

}  // namespace lithe::bake
