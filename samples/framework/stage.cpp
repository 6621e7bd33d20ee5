// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "stage.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace sample {
namespace {

constexpr float kNear = 0.05f, kFar = 500.0f;

}  // namespace

glm::mat4 Camera::viewProjection(float aspect) const {
  return glm::perspective(vertical_fov, aspect, kNear, kFar) * glm::lookAt(position, target, glm::vec3(0, 1, 0));
}

float Camera::pixelsPerRadian(int height) const {
  return static_cast<float>(height) / (2 * std::tan(vertical_fov / 2));
}

glm::mat4 SunView::projection(const glm::vec3& sun) const {
  const float depth = 2 * half_extent;
  const glm::mat4 view = glm::lookAt(center + sun * depth, center, glm::vec3(0, 0, -1));
  return glm::ortho(-half_extent, half_extent, -half_extent, half_extent, 0.0f, 2 * depth) * view;
}

Stage::Stage(int shadow_size)
    : shadow_(shadow_size),
      frame_buffer_(sizeof(FrameBlock)),
      character_(characterVertexShader(), characterFragmentShader()),
      depth_(characterVertexShader(), emptyFragmentShader()),
      wire_(characterVertexShader(), wireFragmentShader()),
      ground_(groundVertexShader(), groundFragmentShader()),
      sky_(skyVertexShader(), skyFragmentShader()) {
  glGenVertexArrays(1, &empty_array_);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_MULTISAMPLE);
  glDepthFunc(GL_LEQUAL);
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frame_buffer_.id());
}

void Stage::setPalettes(const PoseBank& bank) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kPaletteBinding, bank.buffer().id());
}

void Stage::sendFrame() {
  frame_.fog = glm::vec4(look_.fog_density, look_.ground_lines, look_.studio ? 1.0f : 0.0f, look_.checker_cells);
  frame_buffer_.write(std::span<const FrameBlock>(&frame_, 1));
}

void Stage::sendMaterials(std::span<const DrawMaterial> materials) {
  if (!material_buffer_ || material_buffer_->bytes() < materials.size_bytes()) {
    material_buffer_ = std::make_unique<Buffer>(2 * materials.size_bytes() + sizeof(DrawMaterial));
  }
  material_buffer_->write(materials);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kMaterialBinding, material_buffer_->id());
}

void Stage::drawShadows(const SunView& view, const DrawList& casters) {
  frame_.sun_projection = view.projection(look_.sun);
  frame_.sun = glm::vec4(look_.sun, 2 * view.half_extent / static_cast<float>(shadow_.size()));
  frame_.view_projection = frame_.sun_projection;
  sendFrame();
  const std::vector<DrawMaterial> unseen(casters.draws().size());
  sendMaterials(unseen);
  shadow_.bind();
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2.0f, 2.0f);
  depth_.use();
  casters.draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
  shadow_.bindTexture(kShadowUnit);
}

void Stage::drawScene(const Camera& camera, int width, int height, const DrawList& list,
                      std::span<const DrawMaterial> materials) {
  frame_.view_projection = camera.viewProjection(static_cast<float>(width) / static_cast<float>(height));
  frame_.inverse_view_projection = glm::inverse(frame_.view_projection);
  frame_.camera = glm::vec4(camera.position, 1);
  sendFrame();
  sendMaterials(materials);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  character_.use();
  list.draw();
  glBindVertexArray(empty_array_);
  if (look_.ground) {
    ground_.use();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  sky_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  checkGl("drawing the scene");
}

void Stage::drawWires(const DrawList& list, const glm::vec4& color) {
  frame_.line_color = color;
  sendFrame();
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glEnable(GL_POLYGON_OFFSET_LINE);
  glPolygonOffset(-1.0f, -4.0f);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  wire_.use();
  list.draw();
  glDisable(GL_BLEND);
  glDisable(GL_POLYGON_OFFSET_LINE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace sample
