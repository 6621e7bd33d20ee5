// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The triangles around a slot as the kernels want them.
#pragma once

#include <array>
#include <vector>

#include "kernels.h"
#include "node_state.h"
#include "surface.h"

namespace lithe::bake {

struct EdgeWeights {
  std::array<float, 8> by_kind{};  // a border counts before a fold, a fold before a seam
  float border;

  explicit EdgeWeights(const SimplifyOptions& options) : border(static_cast<float>(options.boundary_weight)) {
    for (uint32_t kind = 1; kind < by_kind.size(); ++kind) {
      const double weight = kind & kBorder ? options.boundary_weight
                            : kind & kFold ? options.fold_weight
                                           : options.seam_weight;
      by_kind[kind] = static_cast<float>(weight);
    }
  }

  float of(uint8_t kind) const { return by_kind[kind]; }
};

inline FanFace fanFace(const Face& face, uint32_t slot, const PosedMesh& posed, const EdgeWeights& weights) {
  const uint32_t k = face.knownCornerOf(slot), next = Face::kAfter[k], last = Face::kAfter[k + 1];
  return {posed.at(slot), posed.at(face.corner[next]), posed.at(face.corner[last]), weights.of(face.kind[last]),
          weights.of(face.kind[next])};
}

inline void gatherFan(const Surface& surface, uint32_t slot, const PosedMesh& posed, const EdgeWeights& weights,
                      std::vector<FanFace>& fan) {
  const std::span<const uint32_t> ids = surface.facesAt(slot);
  fan.resize(ids.size());
  for (size_t i = 0; i < ids.size(); ++i) fan[i] = fanFace(surface.face(ids[i]), slot, posed, weights);
}

}  // namespace lithe::bake
