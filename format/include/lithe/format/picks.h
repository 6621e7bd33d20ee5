// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Which wedge a corner gets where a split leaves a choice, as a place in a list whose first entries are the likely
/// ones (docs/format.md, section 4.5).
#pragma once

#include <stdint.h>

#include "lithe/format/file.h"
#include "lithe/format/page.h"

namespace lithe::format {

// ---- Members ----

/// A member of a class, and whether what stands beside the corner suggests it.
struct MemberGuess {
  uint32_t member;
  bool sure;
};

/// The wedges of a class at one child while corners go to them. Member 0 is the class's first, the others are numbered
/// in the order in which they get their first corners.
struct Members {
  uint32_t count = 0;
  uint32_t last = kNoIndex;  ///< that got the corner before; kNoIndex: none
  uint32_t met = 1;          ///< members 1 .. met - 1 have corners
  bool first_met = false;    ///< so has member 0

  constexpr bool lacksCorners() const { return count > 0 && (!first_met || met < count); }
  /// Members that the next corner may go to: those met, and the next one.
  constexpr uint32_t choices() const { return met < count ? met + 1 : count; }

  constexpr void meet(uint32_t member) {
    if (member == 0) first_met = true;
    if (member == met) ++met;
    last = member;
  }

  /// For a corner of the fan: as before.
  constexpr MemberGuess guessForFan() const {
    return last != kNoIndex ? MemberGuess{last, true} : MemberGuess{0, false};
  }

  /// For a new face's corner: a member that would be left without a corner, else that of the fan's corner beside it
  /// (kNoIndex: there is none of this class).
  constexpr MemberGuess guessForFace(uint32_t beside) const {
    if (met < count) return {met, first_met};
    if (!first_met) return {0, true};
    return beside != kNoIndex ? MemberGuess{beside, true} : MemberGuess{0, false};
  }
};

/// 0 is the guess, the others follow in order.
constexpr uint32_t memberSymbol(uint32_t member, uint32_t guess) {
  return member == guess ? 0 : member < guess ? member + 1 : member;
}
constexpr uint32_t memberOf(uint32_t symbol, uint32_t guess) {
  return symbol == 0 ? guess : symbol <= guess ? symbol - 1 : symbol;
}

// ---- New faces ----

/// The fan's corners on either side of a new face (X, c, Y): of Y's edge that starts at c and of X's that ends there;
/// kNoIndex where there is none.
struct CornersBeside {
  uint32_t starts = kNoIndex, ends = kNoIndex;
};

/// at_b(i) tells where the fan's corner i goes. Fans beyond kMaxRing are not searched.
template <class AtB>
CornersBeside cornersBeside(const Fan& fan, const AtB& at_b, uint32_t third, bool first_is_a) {
  CornersBeside beside;
  if (fan.count > kMaxRing) return beside;
  for (uint32_t i = fan.count; i-- > 0;) {
    if (fan.next[i] == third && at_b(i) == first_is_a) beside.starts = i;
    if (fan.previous[i] == third && at_b(i) != first_is_a) beside.ends = i;
  }
  return beside;
}

/// Which wedges of a node have corners. A node with more corners than kMost is taken to have some at each, and so are
/// its wedges from kMost on.
class WedgesInUse {
 public:
  static constexpr uint32_t kMost = 64;

  /// index  of a corner's wedge among the node's. Returns false when there is no need to go on.
  constexpr bool add(uint32_t index) {
    if (index < kMost) used_ |= uint64_t{1} << index;
    if (++corners_ <= kMost) return true;
    used_ = ~uint64_t{0};
    return false;
  }
  constexpr bool has(uint32_t index) const { return index >= kMost || (used_ >> index & 1) != 0; }

 private:
  uint64_t used_ = 0;
  uint32_t corners_ = 0;
};

/// How an entry stands in a list of choices.
enum class Standing : uint8_t { kLacksCorners, kOther, kNoChoice };

/// The choices for a new face's class, or its wedge at the third node: first the candidates, then the others that lack
/// corners, then all others, in ascending order. standing(i) tells of entry i of `count`.
template <class StandingOf>
class PickList {
 public:
  PickList(uint32_t count, const StandingOf& standing) : count_(count), standing_(standing) {
    for (uint32_t i = 0; i < count; ++i) {
      size_ += standing(i) != Standing::kNoChoice;
      lacking_ += standing(i) == Standing::kLacksCorners;
    }
  }

  /// Makes candidates of two entries (kNoIndex: of none), the first before the second unless only that lacks corners.
  void propose(uint32_t first, uint32_t second) {
    const bool turned = lacksCorners(second) && !lacksCorners(first);
    propose(turned ? second : first);
    propose(turned ? first : second);
  }

  uint32_t size() const { return size_; }
  uint32_t candidates() const { return candidates_; }
  /// Whether others than the candidates lack corners.
  bool othersLackCorners() const { return lacking_ > 0; }

  /// kNoIndex beyond the list.
  uint32_t entryAt(uint32_t place) const {
    if (place < candidates_) return candidate_[place];
    uint32_t left = place - candidates_;
    for (const Standing standing : kOrder)
      for (uint32_t i = 0; i < count_; ++i)
        if (standing_(i) == standing && !isCandidate(i) && left-- == 0) return i;
    return kNoIndex;
  }

  /// The size for what is not in the list.
  uint32_t placeOf(uint32_t entry) const {
    for (uint32_t c = 0; c < candidates_; ++c)
      if (candidate_[c] == entry) return c;
    uint32_t place = candidates_;
    for (const Standing standing : kOrder)
      for (uint32_t i = 0; i < count_; ++i) {
        if (standing_(i) != standing || isCandidate(i)) continue;
        if (i == entry) return place;
        ++place;
      }
    return place;
  }

 private:
  static constexpr Standing kOrder[] = {Standing::kLacksCorners, Standing::kOther};

  bool lacksCorners(uint32_t entry) const { return entry != kNoIndex && standing_(entry) == Standing::kLacksCorners; }

  // Once; what is no choice is no candidate.
  void propose(uint32_t entry) {
    if (entry == kNoIndex || standing_(entry) == Standing::kNoChoice || isCandidate(entry)) return;
    lacking_ -= lacksCorners(entry);
    candidate_[candidates_++] = entry;
  }

  bool isCandidate(uint32_t entry) const { return candidate_[0] == entry || candidate_[1] == entry; }

  uint32_t count_, size_ = 0, lacking_ = 0, candidates_ = 0;
  uint32_t candidate_[2] = {kNoIndex, kNoIndex};
  StandingOf standing_;
};

}  // namespace lithe::format
