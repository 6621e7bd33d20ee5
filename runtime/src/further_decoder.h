// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Reads the records of the further wedges that a split's classes have at a child, once all corners are there.
#pragma once

#include "lithe/format/further_wedges.h"
#include "page_streams.h"
#include "wedge_class.h"

namespace lithe::runtime {

class FurtherDecoder {
 public:
  /// greatest  of every entry of a record
  /// classes   of the split whose children are the last two nodes; the first one's wedge is `first_parent_wedge`
  FurtherDecoder(const PageFormat& format, PageStreams* streams, Decoded* decoded, const int64_t* greatest,
                 const WedgeClass* classes, uint32_t class_count, uint32_t first_parent_wedge)
      : format_(format),
        streams_(streams),
        out_(decoded),
        greatest_(greatest),
        classes_(classes),
        class_count_(class_count),
        first_parent_wedge_(first_parent_wedge) {}

  /// Of child A, then of child B. Returns false when a value is out of its range.
  bool run() { return readChild(0) && readChild(1); }

 private:
  bool readChild(uint32_t side);
  void gatherCorners();
  bool readWedge(uint32_t first, uint32_t wedge);
  bool readNormal(uint32_t wedge, const uint16_t* first, uint16_t* out);
  bool readTangent(const uint16_t* first, uint16_t* out);
  bool readUvs(uint32_t wedge, uint32_t mask, const uint16_t* first, uint16_t* out);
  bool readTurned(format::Parameter shift, format::Int2 predicted, uint16_t* out);
  bool readEntries(int32_t low, uint32_t at, uint32_t count, const uint16_t* predicted, uint16_t* out);
  int32_t residual(int32_t low) {
    return splitValue(&streams_->low_bits[format::kLowExtras], streams_->values[format::kExtras], low);
  }
  bool isReadBefore(uint32_t wedge, uint32_t further) const;
  uint16_t* record(uint32_t wedge) const {
    return out_->wedge_attributes + static_cast<size_t>(wedge) * format_.layout.stride;
  }
  format::Int3 position(uint32_t node) const {
    const uint16_t* p = out_->node_position + 3 * static_cast<size_t>(node);
    return {p[0], p[1], p[2]};
  }

  const PageFormat& format_;
  PageStreams* streams_;
  Decoded* out_;
  const int64_t* greatest_;
  const WedgeClass* classes_;
  const uint32_t class_count_, first_parent_wedge_;

  uint32_t child_ = 0;
  format::ChildCorners corners_;
};

}  // namespace lithe::runtime
