// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The triangles around a slot as the kernels want them.
#pragma once

#include <vector>

#include "kernels.h"
#include "node_state.h"
#include "surface.h"

namespace lithe::bake {

struct EdgeWeights {
  float border, seam, fold;

  explicit EdgeWeights(const SimplifyOptions& options)
      : border(static_cast<float>(options.boundary_weight)),
        seam(static_cast<float>(options.seam_weight)),
        fold(static_cast<float>(options.fold_weight)) {}

  float of(uint8_t kind) const {
    if (kind & kBorder) return border;
    if (kind & kFold) return fold;
    return kind & kSeam ? seam : 0.0f;
  }
};

inline FanFace fanFace(const Face& face, uint32_t slot, const PosedMesh& posed, const EdgeWeights& weights) {
  const uint32_t k = face.cornerOf(slot), next = (k + 1) % 3, last = (k + 2) % 3;
  return {posed.at(slot), posed.at(face.corner[next]), posed.at(face.corner[last]), weights.of(face.kind[last]),
          weights.of(face.kind[next])};
}

inline void gatherFan(const Surface& surface, uint32_t slot, const PosedMesh& posed, const EdgeWeights& weights,
                      std::vector<FanFace>& fan) {
  fan.clear();
  for (uint32_t id : surface.facesAt(slot)) fan.push_back(fanFace(surface.face(id), slot, posed, weights));
}

}  // namespace lithe::bake
