// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// An imported character: what the bake works on, independent of the file it came from.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace lithe::bake {

/// Bad input or a failed check: one sentence that names the file, the place and what to do. The tool prints it and
/// exits 1.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr uint32_t kNone = 0xffffffffu;
inline constexpr uint32_t kMaxUvSets = 8;
inline constexpr uint32_t kMaxColorSets = 2;
/// Influences kept per vertex at import (JOINTS_0 and JOINTS_1). The cap of the bake (1..8) is applied later, by
/// weld().
inline constexpr uint32_t kMaxImportedInfluences = 8;

/// A node's local transform: translation, unit quaternion, scale (applied as T * R * S).
struct Transform {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  // w, x, y, z
  glm::dvec3 scale{1.0};

  glm::dmat4 matrix() const;
};

/// One node of the scene graph. Nodes are stored parents first.
struct Node {
  std::string name;         ///< as in the file; may be empty
  uint32_t parent = kNone;  ///< index into Model::nodes, always smaller than the node's own index
  Transform rest;           ///< local transform without animation
};

/// One entry of the matrix palette: world(node) * inverse_bind takes bind space to the posed world.
/// All skins of a file share one palette; a (node, inverse_bind) pair occurs once.
struct Joint {
  uint32_t node = kNone;
  glm::dmat4 inverse_bind{1.0};
};

/// Up to eight influences, weights > 0 summing to 1, sorted by descending weight, ties by ascending joint.
struct Skin {
  uint8_t count = 0;
  std::array<uint16_t, kMaxImportedInfluences> joint{};
  std::array<float, kMaxImportedInfluences> weight{};
};

/// What a triangle belongs to: one glTF primitive, instantiated by one node.
struct Part {
  std::string name;              ///< the mesh's name (the node's where the mesh has none)
  uint32_t material = kNone;     ///< index into Model::materials
  uint32_t rigid_node = kNone;   ///< the node a rigid (unskinned) part is bound to; kNone for a skinned part
  uint32_t source_mesh = kNone;  ///< glTF mesh and primitive it came from
  uint32_t source_primitive = kNone;
};

/// Which vertex attributes the model carries. A bit that is clear means the array is empty.
struct AttributeSet {
  bool normal = false;
  bool tangent = false;
  uint32_t uv_sets = 0;     ///< uv arrays [0, uv_sets) are filled
  uint32_t color_sets = 0;  ///< colour arrays [0, color_sets) are filled
};

/// One animated property of one node.
struct Channel {
  enum class Path : uint8_t { kTranslation, kRotation, kScale };
  enum class Interpolation : uint8_t { kStep, kLinear, kCubicSpline };
  uint32_t node = kNone;
  Path path = Path::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<float> times;       ///< seconds, strictly increasing
  std::vector<glm::vec4> values;  ///< one per key, three per key for cubic splines (in-tangent, value, out-tangent)
};

struct Clip {
  std::string name;
  double begin = 0.0, end = 0.0;  ///< seconds: first and last key of any channel
  std::vector<Channel> channels;
};

/// The character. Vertices are glTF's (one per attribute tuple), all parts concatenated, structure of arrays.
/// Positions, normals and tangents are in bind space: posed = sum_k weight_k * palette[joint_k] * position.
struct Model {
  std::vector<Node> nodes;  ///< every node that is a joint, an ancestor of one, or carries a rigid part; parents first
  std::vector<Joint> joints;  ///< the palette
  std::vector<std::string> materials;
  std::vector<Part> parts;
  AttributeSet attributes;

  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec4> tangents;  ///< w = handedness, +1 or -1
  std::array<std::vector<glm::vec2>, kMaxUvSets> uvs;
  std::array<std::vector<glm::vec4>, kMaxColorSets> colors;  ///< linear, 0..1
  std::vector<Skin> skins;

  std::vector<std::array<uint32_t, 3>> triangles;  ///< vertex indices, counter-clockwise seen from outside
  std::vector<uint32_t> triangle_part;             ///< per triangle, index into parts, ascending

  std::vector<Clip> clips;
  double rest_diagonal = 0.0;  ///< of the bounding box of the file's own vertex positions (skinned parts; before any
                               ///< change of bind space): the unit in which posed errors are stated
  std::vector<std::string> warnings;  ///< one sentence each: what was repaired or dropped
};

/// A posed skeleton: the palette of one instant.
struct Pose {
  std::vector<glm::dmat4> palette;  ///< per Model::joints
  std::string clip;                 ///< empty for sampled poses and the rest pose
  double time = 0.0;                ///< seconds
};

}  // namespace lithe::bake
