// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Collects vertices and triangles part by part and lays them out as a Model wants them: parts one after the other.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

struct SurfacePoint {
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0, 1.0, 0.0};  ///< unit
  glm::dvec2 uv{0.0};
  Skin skin;
};

class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(uint32_t part_count) : parts_(part_count) {}

  /// Returns the vertex's index within its part.
  uint32_t addVertex(uint32_t part, const SurfacePoint& point);

  /// Corners are indices within the part, counter-clockwise seen from outside. A triangle with two corners at one
  /// position (at the pole of a sheet) is left out.
  void addTriangle(uint32_t part, std::array<uint32_t, 3> corners);

  /// A sheet of columns x rows quads; point(column, row) is asked for 0 .. columns and 0 .. rows. Columns run to the
  /// right and rows upwards when the sheet is seen from outside.
  template <typename PointAt>
  void addSheet(uint32_t part, uint32_t columns, uint32_t rows, PointAt&& point) {
    const uint32_t first = static_cast<uint32_t>(parts_[part].positions.size());
    for (uint32_t row = 0; row <= rows; ++row) {
      for (uint32_t column = 0; column <= columns; ++column) addVertex(part, point(column, row));
    }
    for (uint32_t row = 0; row < rows; ++row) {
      for (uint32_t column = 0; column < columns; ++column) {
        const uint32_t a = first + row * (columns + 1) + column, b = a + 1, c = b + columns + 1, d = a + columns + 1;
        addTriangle(part, {a, b, c});
        addTriangle(part, {a, c, d});
      }
    }
  }

  /// Moves all vertices that a triangle uses into the model, whose parts must have been named, and states its
  /// attributes and rest diagonal.
  void finish(Model& model);

 private:
  struct PartSurface {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uvs;
    std::vector<Skin> skins;
    std::vector<std::array<uint32_t, 3>> triangles;
  };
  std::vector<PartSurface> parts_;
};

/// Appends a part and a material of the same index.
void addPart(Model& model, const std::string& name, const std::string& material);

}  // namespace lithe::bake
