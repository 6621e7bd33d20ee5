// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The wedges that a split's corners get: numbers them, moves the corners and adds the new faces, and writes what a
/// reader must be told of it.
#pragma once

#include <array>
#include <vector>

#include "cut.h"
#include "lithe/format/picks.h"
#include "page_streams.h"
#include "split_plan.h"

namespace lithe::bake {

/// A wedge of the split node and what its children get for it; [0] is child A's, [1] child B's.
struct WedgeClass {
  std::array<std::vector<uint32_t>, 2> wedges;  ///< of the hierarchy, in the order of the file
  std::array<format::Members, 2> members;

  bool atBoth() const { return !wedges[0].empty() && !wedges[1].empty(); }
  bool lacksCorners() const { return members[0].lacksCorners() || members[1].lacksCorners(); }
};

class PickEncoder {
 public:
  /// All of them outlive the encoder. The children are not in the cut yet.
  PickEncoder(Cut& cut, uint32_t node, const SplitPlan& plan, const format::Fan& fan, const format::Ring& ring,
              PageData& page);

  /// In the order of the split node's wedges.
  const std::vector<WedgeClass>& classes() const { return classes_; }

  /// Moves the fan's corners and adds the new faces; the children are in the cut.
  void run();
  /// Entries of lists that a reader goes through.
  uint64_t work() const { return work_; }

 private:
  void collectMembers();
  void orderMembers();
  void meet(bool at_b, uint32_t leaf_wedge);
  uint32_t classOf(uint32_t fan_entry) const { return fan_class_[fan_entry]; }
  uint32_t childWedge(bool at_b, uint32_t leaf_wedge) const;
  uint32_t classAbove(uint32_t child_wedge) const;
  uint32_t fanEntry(uint32_t e) const { return listed_ ? e : ring_.edge[e]; }
  void moveFan();
  void addFace(const SplitPlan::NewFace& face);
  format::CornersBeside cornersBeside(const SplitPlan::NewFace& face) const;
  void pickClass(uint32_t wedge_class, const format::CornersBeside& beside);
  void pickThird(uint32_t third, uint32_t wedge, uint32_t wedge_class, const format::CornersBeside& beside);
  uint32_t memberBeside(uint32_t fan_entry, uint32_t wedge_class, bool at_b) const;
  void pickMember(uint32_t wedge_class, bool at_b, uint32_t child_wedge, format::MemberGuess guess);
  void put(format::SplitStream stream, uint32_t value) { page_.streams[stream].put(static_cast<int32_t>(value)); }

  Cut& cut_;
  const SplitPlan& plan_;
  const format::Fan& fan_;
  const format::Ring& ring_;
  PageData& page_;
  const uint32_t node_, first_wedge_;
  const bool listed_;
  std::vector<WedgeClass> classes_;
  std::vector<uint32_t> fan_class_;
  uint64_t work_ = 0;
};

}  // namespace lithe::bake
