// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Reads the skins of a split's children.
#pragma once

#include "lithe/format/ring_prediction.h"
#include "page_streams.h"

namespace lithe::runtime {

class SkinDecoder {
 public:
  /// neighbours  of all corners of the split node, from readChildren() on, unless the mode is kSkinSame
  SkinDecoder(const PageFormat& format, PageStreams* streams, Decoded* decoded,
              const format::RingNeighbours& neighbours)
      : format_(format), streams_(streams), out_(decoded), neighbours_(neighbours) {}

  /// How the skins are said, from the stream of nodes with a fan like this one: a SkinMode, if not beyond them.
  int32_t readMode(uint32_t node, const format::Fan& fan);

  /// The last two nodes are the children. Returns false when a skin is not valid.
  bool readChildren(uint32_t node, int32_t mode, int32_t t8);

 private:
  bool readJoints(const SkinRecord& parent, uint32_t* joints, uint32_t* count);
  format::RingJoints jointsAround(const uint32_t* known, uint32_t known_count) const;
  bool readWeights(const SkinRecord& parent, const uint32_t* joints, uint32_t count, int32_t mode, int32_t t8,
                   int32_t* d, int32_t* of_b);
  int64_t readDifference(const format::RingSlope& around);
  void slopesOfWeights(const SkinRecord& parent, const uint32_t* joints, uint32_t count,
                       format::RingSlope* slopes) const;

  const PageFormat& format_;
  PageStreams* streams_;
  Decoded* out_;
  const format::RingNeighbours& neighbours_;
};

}  // namespace lithe::runtime
