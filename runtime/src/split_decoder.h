// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Applies the splits of a page, one after the other, to the current cut.
#pragma once

#include "lithe/format/octahedral_chart.h"
#include "lithe/format/picks.h"
#include "lithe/format/placement_prediction.h"
#include "lithe/format/ring_prediction.h"
#include "page_streams.h"
#include "skin_order.h"
#include "wedge_class.h"

namespace lithe::runtime {

/// Sums over the faces of one child before it has moved there.
struct SideSum {
  int64_t count;
  int64_t next[3], previous[3];  ///< positions of their two other corners, seen from the split node
  format::AreaNormal normal;     ///< seen from there too

  int64_t neighbours(uint32_t c) const { return next[c] + previous[c]; }
  /// Of the ways from the previous to the next corners.
  int64_t chord(uint32_t c) const { return next[c] - previous[c]; }
};

/// Memory for the node that is being split: max_fan entries each.
struct FanScratch {
  uint32_t capacity;
  uint32_t* corner;  ///< filled from the end
  uint32_t* next;
  uint32_t* previous;
  uint32_t* wedge;            ///< the corner's wedge at the split node, before it moves
  uint32_t* other_wedge[2];   ///< those of its face's next and previous corners
  format::Int3* other_at[2];  ///< and where their nodes lie, seen from the split node
  WedgeClass* classes;        ///< per wedge of the split node
  uint32_t* sorted;           ///< 2 * capacity: the neighbours, for lists that name them by rank
  uint8_t* at_b;
};

class SplitDecoder {
 public:
  SplitDecoder(const PageFormat& format, const PagePlan& plan, PageStreams* streams, const FanScratch& scratch,
               Decoded* decoded);

  /// Applies the page's splits, level by level, beginning with the node *cursor of the first. *cursor is then where the
  /// next page goes on. Returns the check that failed, 0 when all is well.
  uint32_t run(uint32_t* cursor);

 private:
  /// A pair of attributes' difference as far as the ring tells.
  struct Expected {
    format::Int2 difference;
    uint32_t spread;
  };
  struct NewFace {
    uint32_t third;  ///< node between the two children, on the far corner
    bool first_is_a;
  };

  /// Visits the nodes of a level in ascending id until there are node_end of them, or until the last of them.
  uint32_t visitNodes(uint32_t* cursor, uint32_t first_node, uint32_t node_end, bool to_the_last);
  uint32_t splitNode(uint32_t node);
  bool gatherFan(uint32_t node);
  void gatherFaces(format::Int3 center);
  uint32_t readSides();
  uint32_t cutRing(uint32_t value);
  void countFromFarthest(uint32_t* p, uint32_t* q) const;
  uint32_t readList();
  uint32_t listedNode(uint32_t neighbour_count, uint32_t* node);
  uint32_t placeChildren(uint32_t node);
  format::PredictedPlacement predictPlacement(format::Int3 center, format::Int3 d) const;
  int32_t sumSides();
  bool readDifference(uint32_t mean_edge, const format::Plane& plane, int32_t* d);
  void readLattice(format::Int3 d, int32_t step, const format::PredictedPlacement& predicted, int64_t* k);
  uint32_t readClasses(uint32_t node);
  uint32_t readAttributes();
  bool readPair(uint32_t wedge, bool predicted, const uint16_t* parent, uint16_t* a, uint16_t* b);
  void gatherRing(uint32_t wedge);
  format::Int2 normalDifference(uint32_t wedge, const format::OctahedralChart& chart) const;
  Expected expectPair(const uint16_t* parent, uint32_t at, int32_t strength) const;
  Expected expectDirection(const format::ChartedDirection& parent, uint32_t at, int32_t strength) const;
  format::Int3 position(uint32_t node) const {
    const uint16_t* p = out_->node_position + 3 * static_cast<size_t>(node);
    return {p[0], p[1], p[2]};
  }
  bool readDirection(IntReader* high, format::LowBits kind, uint32_t bias, const Expected& expected,
                     const format::ChartedDirection& parent, uint16_t* a, uint16_t* b);
  uint32_t moveFan();
  bool moveToOnlyWedges();
  void linkFan();
  uint32_t addFaces();
  uint32_t addFace(const NewFace& face);
  uint32_t pickWedges(const NewFace& face, uint32_t* wedges);
  uint32_t pickClass(const format::CornersBeside& beside);
  uint32_t pickThird(uint32_t node, uint32_t wedge_class, const format::CornersBeside& beside);
  format::WedgesInUse wedgesInUse(uint32_t node) const;
  uint32_t readSkins(uint32_t node);
  uint32_t readUnsigned(uint32_t stream) { return static_cast<uint32_t>(streams_->values[stream][0].next()); }
  bool childWedge(uint32_t wedge_class, bool at_b, format::MemberGuess guess, uint32_t* wedge);
  uint32_t classOf(uint32_t fan_entry) const { return scratch_.wedge[fan_entry] - first_parent_wedge_; }
  bool pickFaceMember(uint32_t wedge_class, bool at_b, uint32_t beside, uint32_t* wedge);
  int32_t residual(IntReader* high, format::LowBits kind, int32_t low) {
    return splitValue(&streams_->low_bits[kind], high, low);
  }

  const PageFormat& format_;
  const PagePlan& plan_;
  PageStreams* streams_;
  FanScratch scratch_;
  Decoded* out_;
  int64_t greatest_[kMaxStride];

  // The split being applied.
  format::Fan fan_{};
  format::Ring ring_{};
  NewFace ring_faces_[2]{};
  uint32_t face_count_ = 0;
  bool listed_ = false;                ///< sides and faces come from kGeneral
  int32_t t8_ = 0;                     ///< where the node lies: eighths of the way from child B to A
  uint32_t ring_extent_ = 0;           ///< of the ring and of D
  SideSum side_[2];                    ///< child A's and child B's
  format::RingNeighbours neighbours_;  ///< of the corners at one wedge of the split node, or at all
  uint64_t work_ = 0;

  uint32_t first_parent_wedge_ = 0;
  uint32_t class_count_ = 0;
  bool has_further_wedges_ = false;  ///< some class has several members at a child
};

}  // namespace lithe::runtime
