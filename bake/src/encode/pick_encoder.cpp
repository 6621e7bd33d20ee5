// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "pick_encoder.h"

#include <algorithm>

namespace lithe::bake {

using format::kNoIndex;
using format::Standing;

PickEncoder::PickEncoder(Cut& cut, uint32_t node, const SplitPlan& plan, const format::Fan& fan,
                         const format::Ring& ring, PageData& page)
    : cut_(cut),
      plan_(plan),
      fan_(fan),
      ring_(ring),
      page_(page),
      node_(node),
      first_wedge_(cut.node_first_wedge[node]),
      listed_(plan.listed),
      classes_(cut.node_first_wedge[node + 1] - first_wedge_) {
  for (uint32_t i = 0; i < fan.count; ++i)
    fan_class_.push_back(cut.face_wedges[fan.corner[i] / 3][fan.corner[i] % 3] - first_wedge_);
  collectMembers();
  orderMembers();
}

void PickEncoder::collectMembers() {
  const Hierarchy& h = cut_.h;
  for (const bool at_b : {false, true}) {
    const uint32_t child = plan_.child(at_b);
    for (uint32_t w = h.first_wedge[child]; w < h.first_wedge[child + 1]; ++w)
      classes_[classAbove(w)].wedges[at_b].push_back(w);
  }
  for (WedgeClass& c : classes_)
    for (uint32_t side = 0; side < 2; ++side) c.members[side].count = static_cast<uint32_t>(c.wedges[side].size());
}

// Members but for the first are numbered as corners come to them.
void PickEncoder::orderMembers() {
  for (uint32_t e = 0; e < fan_.count; ++e) {
    const uint32_t i = fanEntry(e);
    meet(plan_.at_b[i], cut_.leafWedge(fan_.corner[i]));
  }
  for (const SplitPlan::NewFace& face : plan_.faces) {
    const auto& leaf = cut_.h.face_wedges[face.triangle];
    meet(!face.first_is_a, leaf[face.rotation]);
    meet(face.first_is_a, leaf[(face.rotation + 2) % 3]);
  }
  for (WedgeClass& c : classes_)
    for (format::Members& members : c.members) members = {.count = members.count};
}

void PickEncoder::meet(bool at_b, uint32_t leaf_wedge) {
  const uint32_t wedge = childWedge(at_b, leaf_wedge);
  WedgeClass& c = classes_[classAbove(wedge)];
  std::vector<uint32_t>& wedges = c.wedges[at_b];
  format::Members& members = c.members[at_b];
  uint32_t member = static_cast<uint32_t>(std::find(wedges.begin(), wedges.end(), wedge) - wedges.begin());
  if (member > members.met) {
    std::swap(wedges[member], wedges[members.met]);
    member = members.met;
  }
  members.meet(member);
}

uint32_t PickEncoder::childWedge(bool at_b, uint32_t leaf_wedge) const {
  uint32_t wedge = leaf_wedge;
  while (cut_.h.wedge_node[wedge] != plan_.child(at_b)) wedge = cut_.h.wedge_parent[wedge];
  return wedge;
}

uint32_t PickEncoder::classAbove(uint32_t child_wedge) const {
  return cut_.file_wedge[cut_.h.wedge_parent[child_wedge]] - first_wedge_;
}

void PickEncoder::run() {
  cut_.clearCorners(node_);
  moveFan();
  for (const SplitPlan::NewFace& face : plan_.faces) addFace(face);
}

void PickEncoder::moveFan() {
  for (uint32_t e = 0; e < fan_.count; ++e) {
    const uint32_t i = fanEntry(e), corner = fan_.corner[i];
    const bool at_b = plan_.at_b[i];
    const uint32_t wedge = childWedge(at_b, cut_.leafWedge(corner));
    pickMember(classOf(i), at_b, wedge, classes_[classOf(i)].members[at_b].guessForFan());
    cut_.moveCorner(corner, cut_.file_wedge[wedge]);
  }
}

void PickEncoder::addFace(const SplitPlan::NewFace& face) {
  const auto& leaf = cut_.h.face_wedges[face.triangle];
  const bool first_at_b = !face.first_is_a, last_at_b = face.first_is_a;
  const uint32_t first = childWedge(first_at_b, leaf[face.rotation]);
  const uint32_t last = childWedge(last_at_b, leaf[(face.rotation + 2) % 3]);
  const uint32_t third = cut_.wedgeAt(face.third, leaf[(face.rotation + 1) % 3]);
  const uint32_t wedge_class = classAbove(first);
  const format::CornersBeside beside = cornersBeside(face);
  const WedgeClass& c = classes_[wedge_class];
  pickClass(wedge_class, beside);
  pickMember(wedge_class, first_at_b, first,
             c.members[first_at_b].guessForFace(memberBeside(beside.ends, wedge_class, first_at_b)));
  pickMember(wedge_class, last_at_b, last,
             c.members[last_at_b].guessForFace(memberBeside(beside.starts, wedge_class, last_at_b)));
  pickThird(face.third, third, wedge_class, beside);
  cut_.addFace(face.triangle, face.rotation, {cut_.file_wedge[first], third, cut_.file_wedge[last]});
}

format::CornersBeside PickEncoder::cornersBeside(const SplitPlan::NewFace& face) const {
  return format::cornersBeside(
      fan_, [&](uint32_t i) { return plan_.at_b[i] != 0; }, face.third, face.first_is_a);
}

void PickEncoder::pickClass(uint32_t wedge_class, const format::CornersBeside& beside) {
  const uint32_t count = static_cast<uint32_t>(classes_.size());
  if (count < 2) return;
  work_ += count;
  format::PickList list(count, [&](uint32_t i) {
    if (!classes_[i].atBoth()) return Standing::kNoChoice;
    return classes_[i].lacksCorners() ? Standing::kLacksCorners : Standing::kOther;
  });
  auto candidate = [&](uint32_t entry) { return entry == kNoIndex ? kNoIndex : classOf(entry); };
  list.propose(candidate(beside.starts), candidate(beside.ends));
  if (list.size() < 2) return;
  put(list.candidates() == 1 ? format::kClassPicks : format::kClassChoices, list.placeOf(wedge_class));
}

void PickEncoder::pickThird(uint32_t third, uint32_t wedge, uint32_t wedge_class, const format::CornersBeside& beside) {
  const uint32_t first = cut_.node_first_wedge[third], count = cut_.node_first_wedge[third + 1] - first;
  if (count < 2) return;
  work_ += count;
  const uint32_t part = cut_.h.wedge_part[cut_.wedge_hierarchy[first_wedge_ + wedge_class]];
  format::WedgesInUse in_use;
  for (uint32_t corner : cut_.node_corners[third])
    if (!in_use.add(cut_.face_wedges[corner / 3][corner % 3] - first)) break;
  format::PickList list(count, [&](uint32_t i) {
    if (cut_.h.wedge_part[cut_.wedge_hierarchy[first + i]] != part) return Standing::kNoChoice;
    return in_use.has(i) ? Standing::kOther : Standing::kLacksCorners;
  });
  auto candidate = [&](uint32_t entry, uint32_t step) {
    if (entry == kNoIndex || classOf(entry) != wedge_class) return kNoIndex;
    const uint32_t corner = fan_.corner[entry];
    return cut_.face_wedges[corner / 3][(corner % 3 + step) % 3] - first;
  };
  list.propose(candidate(beside.starts, 1), candidate(beside.ends, 2));
  if (list.size() < 2) return;
  const bool sure = list.candidates() == 1 && !list.othersLackCorners();
  put(sure ? format::kThirdPicks : format::kThirdChoices, list.placeOf(wedge - first));
}

uint32_t PickEncoder::memberBeside(uint32_t fan_entry, uint32_t wedge_class, bool at_b) const {
  if (fan_entry == kNoIndex || classOf(fan_entry) != wedge_class) return kNoIndex;
  const std::vector<uint32_t>& wedges = classes_[wedge_class].wedges[at_b];
  const uint32_t wedge = childWedge(at_b, cut_.leafWedge(fan_.corner[fan_entry]));
  return static_cast<uint32_t>(std::find(wedges.begin(), wedges.end(), wedge) - wedges.begin());
}

void PickEncoder::pickMember(uint32_t wedge_class, bool at_b, uint32_t child_wedge, format::MemberGuess guess) {
  const std::vector<uint32_t>& wedges = classes_[wedge_class].wedges[at_b];
  const uint32_t member = static_cast<uint32_t>(std::find(wedges.begin(), wedges.end(), child_wedge) - wedges.begin());
  if (wedges.size() > 1)
    put(guess.sure ? format::kMemberPicks : format::kMemberChoices, format::memberSymbol(member, guess.member));
  classes_[wedge_class].members[at_b].meet(member);
}

}  // namespace lithe::bake
