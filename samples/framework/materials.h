// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Colours for characters that come without textures: by what their parts and materials are called, or by level.
#pragma once

#include <span>
#include <vector>

#include "character.h"
#include "draw_list.h"
#include "shaders.h"

namespace sample {

/// From blue for the coarsest to red for the finest. Linear.
glm::vec3 levelColor(uint32_t level, uint32_t level_count);

class Materials {
 public:
  explicit Materials(std::span<const Character> characters);

  /// One material per draw of the list, in its order. The span is valid until the next call.
  std::span<const DrawMaterial> forDraws(const DrawList& list, bool by_level);

 private:
  DrawMaterial materialOf(const lithe_draw_key& key, bool by_level) const;

  std::vector<std::vector<DrawMaterial>> parts_;  ///< per character and part
  std::vector<uint32_t> level_counts_;
  std::vector<DrawMaterial> draws_;
};

}  // namespace sample
