// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "overlay.h"

#include <stb_easy_font.h>
#include <cstddef>

#include "shaders.h"

namespace sample {
namespace {

/// stb_easy_font's own vertex: four of them make a rectangle.
struct FontVertex {
  float x, y, z;
  unsigned char color[4];
};

}  // namespace

Overlay::Overlay() : program_(overlayVertexShader(), overlayFragmentShader()) {
  glGenVertexArrays(1, &vertex_array_);
  glGenBuffers(1, &buffer_);
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                        reinterpret_cast<const void*>(offsetof(Vertex, color)));
}

Overlay::~Overlay() {
  glDeleteBuffers(1, &buffer_);
  glDeleteVertexArrays(1, &vertex_array_);
}

float Overlay::textWidth(const std::string& line, float scale) {
  std::string copy = line;
  return scale * static_cast<float>(stb_easy_font_width(copy.data()));
}

void Overlay::quad(const glm::vec2& low, const glm::vec2& high, const glm::vec4& color) {
  const glm::vec2 corners[6] = {low, {high.x, low.y}, high, low, high, {low.x, high.y}};
  for (const glm::vec2& corner : corners) vertices_.push_back({corner, color});
}

void Overlay::box(float x, float y, float width, float height, const glm::vec4& color) {
  quad({x, y}, {x + width, y + height}, color);
}

void Overlay::text(float x, float y, const std::string& line, float scale, const glm::vec4& color) {
  std::string copy = line;
  std::vector<FontVertex> corners(line.size() * 4 * 20 + 4);  // no letter has more than 20 strokes
  const int quads = stb_easy_font_print(0, 0, copy.data(), nullptr, corners.data(),
                                        static_cast<int>(corners.size() * sizeof(FontVertex)));
  for (int i = 0; i < quads; ++i) {
    const FontVertex &low = corners[4 * i], &high = corners[4 * i + 2];
    quad({x + scale * low.x, y + scale * low.y}, {x + scale * high.x, y + scale * high.y}, color);
  }
}

void Overlay::draw(int width, int height) {
  const glm::vec2 size(width, height);
  for (Vertex& vertex : vertices_) {
    vertex.position = vertex.position / size * 2.0f - 1.0f;
    vertex.position.y = -vertex.position.y;
  }
  glViewport(0, 0, width, height);
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices_.size() * sizeof(Vertex)), vertices_.data(),
               GL_STREAM_DRAW);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  program_.use();
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  vertices_.clear();
}

}  // namespace sample
