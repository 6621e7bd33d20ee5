// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "posed_mesh.h"

#include <algorithm>

namespace lithe::bake {

namespace {

using Palette = std::vector<glm::dmat4>;

LITHE_INLINE glm::dvec3 posedVertex(const Mesh& mesh, const Palette& palette, uint32_t vertex) {
  const glm::dvec4 rest(mesh.grid.origin + mesh.grid.step * glm::dvec3(mesh.positions[vertex]), 1.0);
  const QuantizedSkin& skin = mesh.skins[vertex];
  glm::dvec3 posed(0.0);
  for (uint32_t k = 0; k < skin.count; ++k) {
    posed += skin.weight[k] / double(mesh.weight_one) * glm::dvec3(palette[skin.joint[k]] * rest);
  }
  return posed;
}

struct Frame {
  glm::dvec3 middle{0.0};
  double diagonal = 0.0;
};

LITHE_KERNEL Frame frameOf(const Mesh& mesh, const Palette& palette) {
  glm::dvec3 lower(posedVertex(mesh, palette, 0)), upper = lower;
  for (uint32_t v = 1; v < mesh.vertexCount(); ++v) {
    const glm::dvec3 posed = posedVertex(mesh, palette, v);
    lower = glm::min(lower, posed);
    upper = glm::max(upper, posed);
  }
  return {0.5 * (lower + upper), glm::length(upper - lower)};
}

/// From grid coordinates to the frame: (matrix * (origin + step * g) - middle) / unit.
void storeMatrix(const Mesh& mesh, const glm::dmat4& matrix, const Frame& frame, double unit, Affine& affine,
                 uint32_t lane) {
  const glm::dvec3 origin = glm::dvec3(matrix * glm::dvec4(mesh.grid.origin, 1.0)) - frame.middle;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      affine.m[row][column][lane] = static_cast<float>(matrix[column][row] * mesh.grid.step / unit);
    }
    affine.m[row][3][lane] = static_cast<float>(origin[row] / unit);
  }
}

struct Scaled {
  const Affine* matrices;
  float weight;
};

LITHE_KERNEL void sumScaled(const Scaled* terms, uint32_t count, uint32_t blocks, Affine* sum) {
  for (uint32_t block = 0; block < blocks; ++block) {
    Affine total{};
    for (uint32_t k = 0; k < count; ++k) {
      for (uint32_t row = 0; row < 3; ++row) {
        for (uint32_t column = 0; column < 4; ++column)
          total.m[row][column] += terms[k].matrices[block].m[row][column] * terms[k].weight;
      }
    }
    sum[block] = total;
  }
}

LITHE_KERNEL void transformKernel(const Affine* blend, uint32_t blocks, float x, float y, float z, PosedPoint* result) {
  for (uint32_t block = 0; block < blocks; ++block) result[block] = transformed(blend[block], x, y, z);
}

}  // namespace

PosedMesh poseMesh(const Mesh& mesh, const std::vector<Palette>& palettes) {
  PosedMesh posed;
  posed.pose_count = static_cast<uint32_t>(palettes.size());
  posed.blocks = (posed.pose_count + kLanes - 1) / kLanes;
  posed.weight_scale = static_cast<float>(1.0 / mesh.weight_one);
  std::vector<Frame> frames;
  double unit = 0.0;
  for (const Palette& palette : palettes) {
    frames.push_back(frameOf(mesh, palette));
    unit = std::max(unit, frames.back().diagonal);
  }
  posed.unit = unit > 0.0 ? unit : 1.0;

  const auto joint_count = static_cast<uint32_t>(palettes[0].size());
  posed.palette.assign(size_t{joint_count} * posed.blocks, Affine{});
  for (uint32_t p = 0; p < posed.pose_count; ++p) {
    for (uint32_t j = 0; j < joint_count; ++j) {
      Affine& affine = posed.palette[size_t{j} * posed.blocks + p / kLanes];
      storeMatrix(mesh, palettes[p][j], frames[p], posed.unit, affine, p % kLanes);
    }
  }
  posed.positions.resize(size_t{mesh.vertexCount()} * posed.blocks);
  std::vector<Affine> blend(posed.blocks);
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) {
    transformPoint(blendSkin(posed, mesh.skins[v], blend.data()), posed.blocks, glm::vec3(mesh.positions[v]),
                   posed.at(v));
  }
  return posed;
}

const Affine* blendSkin(const PosedMesh& posed, const QuantizedSkin& skin, Affine* storage) {
  const auto matrices = [&](uint16_t joint) { return posed.palette.data() + size_t{joint} * posed.blocks; };
  if (skin.count == 1) return matrices(skin.joint[0]);
  Scaled terms[kMaxImportedInfluences];
  for (uint32_t k = 0; k < skin.count; ++k) terms[k] = {matrices(skin.joint[k]), skin.weight[k] * posed.weight_scale};
  sumScaled(terms, skin.count, posed.blocks, storage);
  return storage;
}

void transformPoint(const Affine* blend, uint32_t blocks, const glm::vec3& grid_point, PosedPoint* result) {
  transformKernel(blend, blocks, grid_point.x, grid_point.y, grid_point.z, result);
}

}  // namespace lithe::bake
