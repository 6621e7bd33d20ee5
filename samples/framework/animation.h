// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Animation stays the engine's: the samples read the clips from the character's glTF and turn them into palettes.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "character.h"

namespace sample {

/// One animated property of one node, sampled linearly (STEP keys jump; cubic keys are read at their values).
struct Channel {
  enum class Path { kTranslation, kRotation, kScale };
  uint32_t node = 0;  ///< index into Character::nodes
  Path path = Path::kTranslation;
  bool step = false;
  std::vector<float> times;       ///< seconds, ascending
  std::vector<glm::vec4> values;  ///< per key; quaternions as x, y, z, w
};

struct Clip {
  std::string name;
  float begin = 0, end = 0;  ///< seconds
  std::vector<Channel> channels;

  float duration() const { return end - begin; }
};

/// The clips of a glTF file that move nodes of the character; nodes are matched by their names from the root down.
/// Throws Error when the file cannot be read.
std::vector<Clip> readClips(const Character& character, const std::filesystem::path& gltf);

/// Poses the character: joint_count matrices of 12 floats (3 rows of 4), world(node) * inverse_bind.
/// clip     nullptr: the rest pose
/// seconds  clamped to the clip
/// palette  receives 12 * joint_count floats
void posePalette(const Character& character, const Clip* clip, float seconds, float* palette);

}  // namespace sample
