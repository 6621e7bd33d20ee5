// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A model in the making: vertices still in the spaces of their skins, joints still as the file lists them.
#pragma once

#include "lithe/bake/model.h"

namespace lithe::bake {

/// One joint of one skin of the file, or the node of a rigid part.
struct FileJoint {
  uint32_t node = kNone;  ///< index into the file's nodes
  glm::dmat4 inverse_bind{1.0};
  uint32_t skin = kNone;  ///< index into the file's skins; kNone for the node of a rigid part

  bool rigid() const { return skin == kNone; }
};

/// Like Skin, but with indices into Draft::joints, in the file's order.
struct FileSkin {
  uint8_t count = 0;
  std::array<uint32_t, kMaxImportedInfluences> joint{};
  std::array<float, kMaxImportedInfluences> weight{};
};

struct Draft {
  Model model;  ///< all but nodes, joints, skins and clips
  std::vector<FileJoint> joints;
  std::vector<FileSkin> skins;      ///< per vertex
  std::vector<uint32_t> part_node;  ///< per part: the file's node that shows it
  std::vector<bool> part_mirrored;  ///< per part: its rest pose is a mirror image of what the file stores
};

}  // namespace lithe::bake
