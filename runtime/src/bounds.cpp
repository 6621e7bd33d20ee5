// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <float.h>

#include "arguments.h"
#include "asset.h"

namespace lithe::runtime {
namespace {

/// Four roundings of the sum below, and as many in whatever skins the vertex.
constexpr float kSlack = 8 * FLT_EPSILON;

struct Box {
  float least[3], greatest[3];
};

float magnitude(float x) { return x < 0 ? -x : x; }

/// The box of a transformed box: its centre goes through the matrix, its half extent through the matrix of magnitudes
/// (Arvo 1990, "Transforming axis-aligned bounding boxes").
Box transformed(const Box& box, const float* matrix) {
  Box out;
  for (uint32_t row = 0; row < 3; ++row) {
    const float* m = matrix + 4 * row;
    float center = m[3], extent = 0, size = magnitude(m[3]);
    for (uint32_t c = 0; c < 3; ++c) {
      const float middle = 0.5f * (box.greatest[c] + box.least[c]), half = 0.5f * (box.greatest[c] - box.least[c]);
      center += m[c] * middle;
      extent += magnitude(m[c]) * half;
      size += magnitude(m[c]) * (magnitude(middle) + half);
    }
    out.least[row] = center - extent - kSlack * size;
    out.greatest[row] = center + extent + kSlack * size;
  }
  return out;
}

}  // namespace
}  // namespace lithe::runtime

using namespace lithe::runtime;  // NOLINT: the C function below is the outside of this namespace

void lithe_asset_posed_box(const lithe_asset* asset, const float* palette, float box[6]) {
  if (!asset || !palette || !box) return void(invalidArgument());
  Box all = {{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
  for (uint32_t joint = 0; joint < asset->head.joints.count; ++joint) {
    Box bind;
    if (!jointBox(asset->head, joint, bind.least, bind.greatest)) continue;
    const Box posed = transformed(bind, palette + 12 * size_t{joint});
    for (uint32_t c = 0; c < 3; ++c) {
      if (posed.least[c] < all.least[c]) all.least[c] = posed.least[c];
      if (posed.greatest[c] > all.greatest[c]) all.greatest[c] = posed.greatest[c];
    }
  }
  for (uint32_t c = 0; c < 3; ++c) {
    box[c] = all.least[c];
    box[3 + c] = all.greatest[c];
  }
}
