// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The stage that characters stand on: sun with shadows, sky, ground, fog, and the pass that draws a list of them.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "draw_list.h"
#include "gl_objects.h"
#include "pose_bank.h"
#include "shaders.h"

namespace sample {

struct Camera {
  glm::vec3 position{0, 1.6f, 5}, target{0, 1, 0};
  float vertical_fov = glm::radians(45.0f);

  glm::mat4 viewProjection(float aspect) const;
  /// What lithe asks for: pixels per radian at the picture's centre.
  float pixelsPerRadian(int height) const;
};

/// The piece of the world whose shadows are drawn: a cube seen from the sun.
struct SunView {
  glm::vec3 center{0};
  float half_extent = 20;  ///< world units

  glm::mat4 projection(const glm::vec3& sun) const;
};

class Stage {
 public:
  struct Look {
    glm::vec3 sun = glm::normalize(glm::vec3(0.45f, 0.8f, 0.5f));
    float fog_density = 0;
    float ground_lines = 1;  ///< 0..1
    bool studio = false;     ///< a plain background instead of the sky
    bool ground = true;
    float checker_cells = 0;  ///< per unit of u and v, instead of the materials' colours; 0: none
  };

  explicit Stage(int shadow_size = 2048);

  const Look& look() const { return look_; }
  void setLook(const Look& look) { look_ = look; }
  int shadowSize() const { return shadow_.size(); }

  /// Where palettes come from and what the draws look like.
  void setPalettes(const PoseBank& bank);

  /// Draws the casters' depth as the sun sees them. First of a frame.
  void drawShadows(const SunView& view, const DrawList& casters);
  /// Draws to the bound target, which it clears.
  void drawScene(const Camera& camera, int width, int height, const DrawList& list,
                 std::span<const DrawMaterial> materials);
  /// The list's edges over what drawScene has drawn.
  void drawWires(const DrawList& list, const glm::vec4& color);

 private:
  void sendFrame();
  void sendMaterials(std::span<const DrawMaterial> materials);

  Look look_;
  FrameBlock frame_;
  ShadowMap shadow_;
  Buffer frame_buffer_;
  std::unique_ptr<Buffer> material_buffer_;
  Program character_, depth_, wire_, ground_, sky_;
  GLuint empty_array_ = 0;  ///< for draws that make their vertices from their number
};

}  // namespace sample
