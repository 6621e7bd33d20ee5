// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The measured part of a model, and its shape at an instant.
#pragma once

#include <span>
#include <vector>

#include "frames.h"
#include "lithe/bake/nearest.h"

namespace lithe::bake {

/// The parts of a model that are compared: used vertices only, structure of arrays. Skins index Model::joints.
struct MeasuredSurface {
  std::vector<glm::dvec3> positions;  ///< bind space
  std::vector<glm::dvec3> normals;    ///< bind space; empty where the model has none
  std::vector<glm::dvec2> uvs;        ///< set 0; empty where the model has none
  std::vector<Skin> skins;
  std::vector<Triangle> triangles;
};

/// @param who  "original" or "simplified", for the message
/// @throws Error when nothing is left to measure
MeasuredSurface surfaceOf(const Model& model, bool include_rigid, const char* who);

/// Which of the original's nodes each joint of `model` follows.
std::vector<uint32_t> matchJoints(const Model& original, const Model& model);

struct PosedSurface {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  ///< unit, or zero where a vertex has none; per vertex
};

/// Skins the surface with palette[joint] = world of the joint's matched node * the joint's own inverse bind.
std::vector<glm::dmat4> paletteAt(const Instant& instant, const std::vector<Joint>& joints,
                                  const std::vector<uint32_t>& node_of_joint);
PosedSurface poseSurface(const MeasuredSurface& surface, std::span<const glm::dmat4> palette);

/// Diagonal of the bounding box.
double diagonalOf(std::span<const glm::dvec3> positions);

}  // namespace lithe::bake
