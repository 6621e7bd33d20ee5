// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// One character in one pose in a studio, drawn at any of its levels.
#pragma once

#include <string>
#include <vector>

#include "animation.h"
#include "character.h"
#include "draw_list.h"
#include "geometry.h"
#include "materials.h"
#include "overlay.h"
#include "picture.h"
#include "pose_bank.h"
#include "stage.h"

struct PoseChoice {
  std::string clip;       ///< empty: the file's first; none in the file: the rest pose
  float fraction = 0.2f;  ///< of the clip, 0..1
  float turn = 35;        ///< degrees that the character is turned from facing the camera
  float elevation = 9;    ///< degrees that the camera looks down
};

/// How one level is shown.
struct Shot {
  uint32_t level = 0;
  int width = 400, height = 400;
  float pixels_per_unit = 0;  ///< of the character on the picture; 0: it fills the picture
  bool wires = false;
  bool checker = false;  ///< a checkerboard laid over the uvs, instead of the materials' colours
  bool ground = true;
  std::vector<std::string> labels;  ///< lines at the foot of the picture
};

class LevelScene {
 public:
  /// Loads every level. Throws sample::Error, also when the clip does not exist. Needs a current context.
  LevelScene(sample::Character character, const std::filesystem::path& gltf, const PoseChoice& choice);

  const sample::Character& character() const { return characters_.front(); }
  /// Of the posed, turned box; in the unit of the levels' errors.
  float posedHeight() const { return high_.y - low_.y; }
  float posedWidth() const { return high_.x - low_.x; }

  sample::Picture draw(const Shot& shot);

 private:
  void measure();
  void placeInstance(uint32_t level);
  sample::Camera frame(const Shot& shot) const;
  void drawLabels(const Shot& shot);

  std::vector<sample::Character> characters_;
  sample::PoseBank bank_;
  sample::Geometry geometry_;
  sample::DrawList list_;
  sample::Stage stage_;
  sample::Materials materials_;
  sample::Overlay overlay_;
  uint32_t phase_;
  float elevation_;  ///< radians
  glm::vec2 heading_;
  glm::vec3 low_{0}, high_{0};  ///< posed box, turned, standing on the ground
  float lift_ = 0;
};
