// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The GLSL of the samples and the bindings that it shares with the C++ side.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace sample {

// Shader storage blocks of the character shader.
inline constexpr unsigned kPaletteBinding = 0;   ///< PoseBank
inline constexpr unsigned kInstanceBinding = 1;  ///< InstanceRecord per instance of a draw list
inline constexpr unsigned kOrderBinding = 2;     ///< what lithe_build_draws calls instance_order
inline constexpr unsigned kMaterialBinding = 3;  ///< DrawMaterial per draw
// Uniform block and texture units.
inline constexpr unsigned kFrameBinding = 0;
inline constexpr unsigned kShadowUnit = 0;

/// What all shaders know of a frame. Layout of std140.
struct FrameBlock {
  glm::mat4 view_projection{1}, inverse_view_projection{1}, sun_projection{1};
  glm::vec4 camera{0};        ///< world position
  glm::vec4 sun{0, 1, 0, 0};  ///< direction towards it; w: the world size of a shadow texel
  glm::vec4 fog{
      0};  ///< x: density per unit; y: lines on the ground 0..1; z: a studio without sky 0..1; w: checker's cells
  glm::vec4 line_color{0, 0, 0, 1};  ///< of the wireframe
};

/// How a draw's surface looks. Layout of std430.
struct DrawMaterial {
  glm::vec4 color{1};      ///< linear; w: gloss 0..1
  glm::vec4 variation{0};  ///< over the instances: x: hue, y: brightness, z: saturation, each 0..1
};

std::string characterVertexShader();
std::string characterFragmentShader();
std::string wireFragmentShader();
/// Depth only: no colour is written.
std::string emptyFragmentShader();
std::string groundVertexShader();
std::string groundFragmentShader();
std::string skyVertexShader();
std::string skyFragmentShader();
std::string overlayVertexShader();
std::string overlayFragmentShader();

}  // namespace sample
