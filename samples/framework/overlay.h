// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Text and boxes over a picture.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "gl_objects.h"

namespace sample {

/// Collects text and boxes in pixels from the top left, then draws them at once.
class Overlay {
 public:
  Overlay();
  ~Overlay();
  Overlay(const Overlay&) = delete;
  Overlay& operator=(const Overlay&) = delete;

  /// scale: pixels per dot of the font, whose capitals are 7 dots high. Colours are as shown (sRGB).
  void text(float x, float y, const std::string& line, float scale, const glm::vec4& color);
  void box(float x, float y, float width, float height, const glm::vec4& color);
  /// Pixels that a line takes.
  static float textWidth(const std::string& line, float scale);

  /// Draws to the bound framebuffer of this size and forgets what was collected.
  void draw(int width, int height);

 private:
  struct Vertex {
    glm::vec2 position;
    glm::vec4 color;
  };

  void quad(const glm::vec2& low, const glm::vec2& high, const glm::vec4& color);

  std::vector<Vertex> vertices_;
  Program program_;
  GLuint vertex_array_ = 0, buffer_ = 0;
};

}  // namespace sample
