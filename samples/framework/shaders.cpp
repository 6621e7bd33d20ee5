// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "shaders.h"

namespace sample {
namespace {

constexpr char kVersion[] = R"(#version 430 core
layout(std140, binding = 0) uniform Frame {
  mat4 view_projection, inverse_view_projection, sun_projection;
  vec4 camera, sun, fog, line_color;
};
)";

// One matrix per joint, three rows each; every instance names the first row of its palette.
constexpr char kSkinning[] = R"(
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec2 in_normal;
layout(location = 2) in uvec4 in_joints_low;
layout(location = 3) in uvec4 in_joints_high;
layout(location = 4) in vec4 in_weights_low;
layout(location = 5) in vec4 in_weights_high;
layout(location = 6) in vec2 in_uv;

struct Instance { float x, y, z, scale; vec2 heading; uint first_row, seed; };
struct Material { vec4 color, variation; };
layout(std430, binding = 0) readonly buffer Palettes { vec4 palette_rows[]; };
layout(std430, binding = 1) readonly buffer Instances { Instance instances[]; };
layout(std430, binding = 2) readonly buffer Order { uint instance_order[]; };
layout(std430, binding = 3) readonly buffer Materials { Material materials[]; };

struct Rows { vec4 x, y, z; };

void addInfluence(inout Rows rows, uint first_row, uint joint, float weight) {
  uint row = first_row + 3u * joint;
  rows.x += weight * palette_rows[row];
  rows.y += weight * palette_rows[row + 1u];
  rows.z += weight * palette_rows[row + 2u];
}

Rows blendedRows(uint first_row) {
  Rows rows = Rows(vec4(0), vec4(0), vec4(0));
  for (int i = 0; i < 4; ++i) addInfluence(rows, first_row, in_joints_low[i], in_weights_low[i]);
  if (in_weights_high.x > 0.0) {
    for (int i = 0; i < 4; ++i) addInfluence(rows, first_row, in_joints_high[i], in_weights_high[i]);
  }
  return rows;
}

vec3 decodeOctahedral(vec2 e) {
  vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
  float fold = max(-n.z, 0.0);
  n.xy += mix(vec2(fold), vec2(-fold), greaterThanEqual(n.xy, vec2(0)));
  return normalize(n);
}

vec3 turned(vec2 heading, vec3 v) {
  return vec3(heading.x * v.x + heading.y * v.z, v.y, heading.x * v.z - heading.y * v.x);
}
)";

constexpr char kCharacterVertex[] = R"(
out vec3 world_position, world_normal;
out vec2 uv;
flat out vec4 surface;  // colour, gloss

float hash(uint seed, uint stream) {
  seed = (seed ^ (stream * 0x9e3779b9u)) * 0x85ebca6bu;
  seed = (seed ^ (seed >> 13)) * 0xc2b2ae35u;
  return float((seed ^ (seed >> 16)) & 0xffffu) / 65535.0;
}

vec3 rotatedHue(vec3 color, float angle) {
  const vec3 grey = vec3(0.57735);
  return max(color * cos(angle) + cross(grey, color) * sin(angle) + grey * dot(grey, color) * (1.0 - cos(angle)), 0.0);
}

vec3 instanceColor(Material material, uint seed) {
  vec3 color = rotatedHue(material.color.rgb, (hash(seed, 1u) - 0.5) * 6.2832 * material.variation.x);
  color = mix(color, vec3(dot(color, vec3(0.2126, 0.7152, 0.0722))), hash(seed, 2u) * material.variation.z);
  return color * mix(1.0, 0.25 + hash(seed, 3u), material.variation.y);
}

void main() {
  Instance instance = instances[instance_order[gl_BaseInstanceARB + gl_InstanceID]];
  Rows rows = blendedRows(instance.first_row);
  vec4 bind = vec4(in_position, 1);
  vec3 posed = vec3(dot(rows.x, bind), dot(rows.y, bind), dot(rows.z, bind));
  vec3 normal = decodeOctahedral(in_normal);
  normal = vec3(dot(rows.x.xyz, normal), dot(rows.y.xyz, normal), dot(rows.z.xyz, normal));
  world_position = vec3(instance.x, instance.y, instance.z) + instance.scale * turned(instance.heading, posed);
  world_normal = turned(instance.heading, normal);
  uv = in_uv;
  Material material = materials[gl_DrawIDARB];
  surface = vec4(instanceColor(material, instance.seed), material.color.w);
  gl_Position = view_projection * vec4(world_position, 1);
}
)";

constexpr char kLighting[] = R"(
layout(binding = 0) uniform sampler2DShadow shadow_map;

vec3 skyColor(vec3 direction) {
  float up = clamp(direction.y, 0.0, 1.0);
  vec3 outside = mix(vec3(0.62, 0.72, 0.84), vec3(0.10, 0.24, 0.55), pow(up, 0.5));
  outside += vec3(0.35, 0.25, 0.12) * pow(max(dot(direction, sun.xyz), 0.0), 24.0);
  return mix(outside, vec3(1.1), fog.z);
}

float sunlight(vec3 position, vec3 normal) {
  vec3 moved = position + normal * sun.w * 2.0;
  vec3 at = (sun_projection * vec4(moved, 1)).xyz * 0.5 + 0.5;
  if (any(lessThan(at, vec3(0))) || any(greaterThan(at, vec3(1)))) return 1.0;
  vec2 texel = 1.0 / vec2(textureSize(shadow_map, 0));
  float lit = 0.0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) lit += texture(shadow_map, vec3(at.xy + vec2(x, y) * texel * 1.2, at.z - 0.0006));
  }
  return lit / 9.0;
}

vec3 lightSurface(vec3 color, float gloss, vec3 position, vec3 normal, float occlusion) {
  vec3 view = normalize(camera.xyz - position);
  float facing = max(dot(normal, sun.xyz), 0.0);
  float lit = facing > 0.0 ? sunlight(position, normal) * facing : 0.0;
  vec3 above = mix(vec3(0.24, 0.21, 0.18), vec3(0.55, 0.70, 0.95), 0.5 + 0.5 * normal.y);
  vec3 light = above * 0.7 * occlusion + vec3(2.7, 2.3, 1.8) * lit;
  float rim = pow(1.0 - max(dot(normal, view), 0.0), 3.0);
  vec3 shine = vec3(1.0, 0.95, 0.85) * gloss * lit * pow(max(dot(normal, normalize(sun.xyz + view)), 0.0), 8.0 + 90.0 * gloss);
  return color * light + shine * 1.6 + above * rim * (0.04 + 0.22 * gloss) * occlusion;
}

// Hable-like shoulder: the fit of the ACES curve by Krzysztof Narkowicz (2016).
vec3 toneMapped(vec3 x) {
  x *= 0.62;
  return pow(clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0), vec3(1.0 / 2.2));
}

vec3 fogged(vec3 color, vec3 position) {
  vec3 way = position - camera.xyz;
  float clear = exp(-pow(length(way) * fog.x, 2.0));
  return mix(skyColor(normalize(vec3(way.x, 0.0, way.z))), color, clear);
}
)";

constexpr char kCharacterFragment[] = R"(
in vec3 world_position, world_normal;
in vec2 uv;
flat in vec4 surface;
out vec4 color;

// The share of a pixel that the light cells cover: a triangle wave, integrated over the pixel in u and in v.
float lightCells(vec2 at) {
  vec2 pixel = max(fwidth(at), vec2(1e-4));
  vec2 before = fract((at - 0.5 * pixel) * 0.5), after = fract((at + 0.5 * pixel) * 0.5);
  vec2 wave = 2.0 * (abs(before - 0.5) - abs(after - 0.5)) / pixel;
  return 0.5 - 0.5 * clamp(wave.x, -1.0, 1.0) * clamp(wave.y, -1.0, 1.0);
}

// Hues turn with u and v, so that a chart that slips shows.
vec3 checkered(float cells) {
  vec3 light = vec3(0.80, 0.78, 0.74), dark = 0.12 + 0.30 * vec3(fract(uv.x), 0.35, fract(uv.y));
  return mix(dark, light, lightCells(uv * cells));
}

void main() {
  // A character without normals comes with zeros: its faces are flat.
  vec3 normal = dot(world_normal, world_normal) > 1e-8
      ? normalize(world_normal) * (gl_FrontFacing ? 1.0 : -1.0)
      : normalize(cross(dFdx(world_position), dFdy(world_position)));
  float occlusion = mix(0.5, 1.0, smoothstep(-0.1, 0.9, world_position.y + 0.25 * normal.y));
  vec3 lit = lightSurface(fog.w > 0.0 ? checkered(fog.w) : surface.rgb, surface.a, world_position, normal, occlusion);
  color = vec4(toneMapped(fogged(lit, world_position)), 1);
}
)";

constexpr char kWireFragment[] = R"(
out vec4 color;
void main() { color = line_color; }
)";

constexpr char kEmptyFragment[] = R"(
void main() {}
)";

constexpr char kGroundVertex[] = R"(
out vec3 world_position;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  world_position = vec3(camera.x + 300.0 * corner.x, 0.0, camera.z + 300.0 * corner.y);
  gl_Position = view_projection * vec4(world_position, 1);
}
)";

constexpr char kGroundFragment[] = R"(
in vec3 world_position;
out vec4 color;

float lines(float spacing, float width) {
  vec2 at = world_position.xz / spacing;
  vec2 pixel = fwidth(at);
  vec2 away = abs(fract(at - 0.5) - 0.5) * spacing;
  vec2 soft = max(pixel * spacing, vec2(1e-4));
  vec2 line = (1.0 - smoothstep(vec2(width), vec2(width) + soft, away)) * clamp(width / soft, 0.0, 1.0);
  return max(line.x, line.y);
}

void main() {
  // In a studio the ground is the background: only shadows tell where it is.
  vec3 studio = toneMapped(skyColor(vec3(0))) * mix(vec3(0.66, 0.69, 0.75), vec3(1), sunlight(world_position, vec3(0, 1, 0)));
  vec3 plain = vec3(0.150, 0.152, 0.148);
  vec3 marked = mix(plain, plain * 0.55, fog.y * max(0.5 * lines(1.0, 0.012), lines(5.0, 0.03)));
  vec3 lit = lightSurface(marked, 0.0, world_position, vec3(0, 1, 0), 1.0);
  color = vec4(fog.z > 0.0 ? studio : toneMapped(fogged(lit, world_position)), 1);
}
)";

constexpr char kSkyVertex[] = R"(
out vec3 direction;
void main() {
  vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0;
  vec4 far = inverse_view_projection * vec4(corner, 1, 1);
  direction = far.xyz / far.w - camera.xyz;
  gl_Position = vec4(corner, 1, 1);
}
)";

constexpr char kSkyFragment[] = R"(
in vec3 direction;
out vec4 color;
void main() { color = vec4(toneMapped(skyColor(normalize(direction))), 1); }
)";

constexpr char kOverlayVertex[] = R"(#version 430 core
layout(location = 0) in vec2 in_position;  // -1 .. 1, y up
layout(location = 1) in vec4 in_color;
out vec4 tint;
void main() {
  tint = in_color;
  gl_Position = vec4(in_position, 0, 1);
}
)";

constexpr char kOverlayFragment[] = R"(#version 430 core
in vec4 tint;
out vec4 color;
void main() { color = tint; }
)";

}  // namespace

std::string characterVertexShader() {
  std::string version = kVersion;
  // gl_DrawID says which material, gl_BaseInstance which part of the order.
  version.insert(version.find('\n') + 1, "#extension GL_ARB_shader_draw_parameters : require\n");
  return version + kSkinning + kCharacterVertex;
}
std::string characterFragmentShader() { return std::string(kVersion) + kLighting + kCharacterFragment; }
std::string wireFragmentShader() { return std::string(kVersion) + kWireFragment; }
std::string emptyFragmentShader() { return std::string(kVersion) + kEmptyFragment; }
std::string groundVertexShader() { return std::string(kVersion) + kGroundVertex; }
std::string groundFragmentShader() { return std::string(kVersion) + kLighting + kGroundFragment; }
std::string skyVertexShader() { return std::string(kVersion) + kSkyVertex; }
std::string skyFragmentShader() { return std::string(kVersion) + kLighting + kSkyFragment; }
std::string overlayVertexShader() { return kOverlayVertex; }
std::string overlayFragmentShader() { return kOverlayFragment; }

}  // namespace sample
