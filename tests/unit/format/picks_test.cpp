// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Guesses of members and lists of choices, by the table and the rules of section 4.5 of docs/format.md.
#include "lithe/format/picks.h"

#include <gtest/gtest.h>

#include <vector>

namespace lithe::format {
namespace {

using Entries = std::vector<uint32_t>;

Members members(uint32_t count, std::initializer_list<uint32_t> met) {
  Members m;
  m.count = count;
  for (uint32_t member : met) m.meet(member);
  return m;
}

void expectGuess(MemberGuess guess, uint32_t member, bool sure) {
  EXPECT_EQ(guess.member, member);
  EXPECT_EQ(guess.sure, sure);
}

TEST(Members, AreMetOneAfterTheOther) {
  EXPECT_EQ(members(3, {}).choices(), 2u);
  EXPECT_EQ(members(3, {0}).choices(), 2u);
  EXPECT_EQ(members(3, {1}).choices(), 3u);
  EXPECT_EQ(members(3, {1, 2, 0}).choices(), 3u);
  EXPECT_EQ(members(1, {}).choices(), 1u);
  EXPECT_EQ(members(0, {}).choices(), 0u);
}

TEST(Members, LackCornersUntilAllAreMet) {
  EXPECT_FALSE(members(0, {}).lacksCorners());
  EXPECT_TRUE(members(1, {}).lacksCorners());
  EXPECT_FALSE(members(1, {0}).lacksCorners());
  EXPECT_TRUE(members(2, {0}).lacksCorners());
  EXPECT_TRUE(members(2, {1}).lacksCorners());
  EXPECT_FALSE(members(2, {1, 0}).lacksCorners());
}

TEST(Members, GuessForTheFanIsTheLast) {
  expectGuess(members(3, {}).guessForFan(), 0, false);
  expectGuess(members(3, {1, 2, 1}).guessForFan(), 1, true);
}

TEST(Members, GuessForAFaceIsOneWithoutACorner) {
  expectGuess(members(3, {0}).guessForFace(0), 1, true);
  expectGuess(members(3, {1}).guessForFace(1), 2, false);
  expectGuess(members(2, {1}).guessForFace(1), 0, true);
  expectGuess(members(2, {0, 1}).guessForFace(1), 1, true);
  expectGuess(members(2, {0, 1}).guessForFace(kNoIndex), 0, false);
}

TEST(Members, SymbolsAreThePlacesBehindTheGuess) {
  for (uint32_t guess = 0; guess < 5; ++guess) {
    Entries order = {guess};
    for (uint32_t member = 0; member < 5; ++member)
      if (member != guess) order.push_back(member);
    for (uint32_t symbol = 0; symbol < 5; ++symbol) {
      EXPECT_EQ(memberOf(symbol, guess), order[symbol]);
      EXPECT_EQ(memberSymbol(order[symbol], guess), symbol);
    }
    for (uint32_t symbol : {5u, 1000u, 0xffffffffu}) EXPECT_GE(memberOf(symbol, guess), 5u);
  }
}

/// The list of entries of which some lack corners and some are no choice, with two proposed.
Entries listed(const std::vector<Standing>& standings, uint32_t first, uint32_t second) {
  PickList list(static_cast<uint32_t>(standings.size()), [&](uint32_t i) { return standings[i]; });
  list.propose(first, second);
  Entries entries;
  for (uint32_t place = 0; place < list.size(); ++place) {
    entries.push_back(list.entryAt(place));
    EXPECT_EQ(list.placeOf(entries.back()), place);
  }
  for (uint32_t place : {list.size(), 1000u, 0xffffffffu}) EXPECT_EQ(list.entryAt(place), kNoIndex);
  return entries;
}

constexpr Standing kLacks = Standing::kLacksCorners, kOther = Standing::kOther, kNone = Standing::kNoChoice;

TEST(PickList, CandidatesComeFirstThenWhatLacksCorners) {
  const std::vector<Standing> standings = {kOther, kLacks, kNone, kOther, kLacks};
  EXPECT_EQ(listed(standings, kNoIndex, kNoIndex), (Entries{1, 4, 0, 3}));
  EXPECT_EQ(listed(standings, 3, kNoIndex), (Entries{3, 1, 4, 0}));
  EXPECT_EQ(listed(standings, kNoIndex, 4), (Entries{4, 1, 0, 3}));
  EXPECT_EQ(listed(standings, 3, 0), (Entries{3, 0, 1, 4}));
  EXPECT_EQ(listed(standings, 3, 3), (Entries{3, 1, 4, 0}));
  EXPECT_EQ(listed(standings, 2, 0), (Entries{0, 1, 4, 3}));
}

TEST(PickList, ACandidateThatAloneLacksCornersComesFirst) {
  const std::vector<Standing> standings = {kOther, kLacks, kLacks};
  EXPECT_EQ(listed(standings, 0, 1), (Entries{1, 0, 2}));
  EXPECT_EQ(listed(standings, 1, 0), (Entries{1, 0, 2}));
  EXPECT_EQ(listed(standings, 2, 1), (Entries{2, 1, 0}));
}

TEST(PickList, MayBeEmpty) {
  EXPECT_EQ(listed({}, kNoIndex, kNoIndex), Entries{});
  EXPECT_EQ(listed({kNone, kNone}, 0, 1), Entries{});
}

TEST(PickList, CountsCandidatesAndOthersThatLackCorners) {
  const std::vector<Standing> standings = {kOther, kLacks, kNone};
  PickList list(3, [&](uint32_t i) { return standings[i]; });
  EXPECT_EQ(list.size(), 2u);
  EXPECT_EQ(list.candidates(), 0u);
  EXPECT_TRUE(list.othersLackCorners());
  list.propose(1, 2);
  EXPECT_EQ(list.candidates(), 1u);
  EXPECT_FALSE(list.othersLackCorners());
}

TEST(WedgesInUse, AreThoseAdded) {
  WedgesInUse in_use;
  EXPECT_TRUE(in_use.add(3));
  EXPECT_TRUE(in_use.add(63));
  EXPECT_TRUE(in_use.add(1000));
  for (uint32_t index = 0; index < 70; ++index) EXPECT_EQ(in_use.has(index), index == 3 || index >= 63);
}

TEST(WedgesInUse, OfManyCornersAreAll) {
  WedgesInUse in_use;
  for (uint32_t corner = 0; corner < 64; ++corner) EXPECT_TRUE(in_use.add(0));
  EXPECT_FALSE(in_use.has(1));
  EXPECT_FALSE(in_use.add(0));
  EXPECT_TRUE(in_use.has(1));
}

TEST(CornersBeside, AreTheFirstOnTheirSides) {
  // Edges from next to previous; the last two go to B.
  uint32_t corner[] = {0, 3, 6, 9}, next[] = {5, 6, 7, 5}, previous[] = {6, 7, 5, 6};
  const Fan fan{4, corner, next, previous};
  auto at_b = [](uint32_t i) { return i >= 2; };
  const CornersBeside a_first = cornersBeside(fan, at_b, 5, true);
  EXPECT_EQ(a_first.starts, 3u);
  EXPECT_EQ(a_first.ends, kNoIndex);
  const CornersBeside b_first = cornersBeside(fan, at_b, 5, false);
  EXPECT_EQ(b_first.starts, 0u);
  EXPECT_EQ(b_first.ends, 2u);
  const Fan large{kMaxRing + 1, corner, next, previous};
  EXPECT_EQ(cornersBeside(large, at_b, 5, false).starts, kNoIndex);
}

}  // namespace
}  // namespace lithe::format
