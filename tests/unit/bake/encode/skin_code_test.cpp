// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Skins written by encodeSkins(), read back with section 4.6 of docs/format.md.
#include "skin_code.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lithe/bake/skin_weights.h"
#include "lithe/format/placement.h"
#include "page_reader.h"
#include "random_character.h"
#include "small_mesh.h"

namespace lithe::bake {
namespace {

using test::skinOf;

constexpr int32_t kOne = 255;

struct Children {
  QuantizedSkin a, b;
};

/// Without neighbours an eighth of the greatest weight counts as the ring's spread.
int32_t lowOf(const PageData& page) { return format::lowBits(kOne / 8, page.parameters[format::kSkinBias]); }

/// Reads streams from the front.
class SkinReader {
 public:
  explicit SkinReader(const PageData& page) : page_(page), low_bits_(page.low_bits[format::kLowSkins]) {}

  Children read(const QuantizedSkin& parent, int32_t t8) {
    const int32_t mode = page_.streams[format::kSkinModesAll].attributes[0].values.at(modes_++);
    if (mode == 0) return {parent, parent};
    std::vector<uint16_t> joints(parent.joint.begin(), parent.joint.begin() + parent.count);
    std::vector<int32_t> old(parent.weight.begin(), parent.weight.begin() + parent.count);
    for (int32_t lacking = next(format::kSkinNew, news_); lacking > 0; --lacking) {
      joints.push_back(static_cast<uint16_t>(next(format::kSkinNew, news_)));
      old.push_back(0);
    }
    std::vector<int32_t> d(joints.size(), 0), b(joints.size(), 0);
    int32_t sum_d = 0, sum_b = 0;
    for (size_t i = 0; i < joints.size(); ++i) {
      const bool last = i + 1 == joints.size();
      d[i] = last ? -sum_d : nextDifference();
      sum_d += d[i];
      if (mode == 1)
        b[i] = old[i] - format::eighths(d[i], t8);
      else
        b[i] = last ? kOne - sum_b : old[i] + next(format::kSkinE, es_);
      sum_b += b[i];
    }
    if (mode == 1) b[0] += kOne - sum_b;
    std::vector<int32_t> a(b);
    for (size_t i = 0; i < a.size(); ++i) a[i] += d[i];
    return {sorted(joints, a), sorted(joints, b)};
  }

  bool atEnd() const {
    return modes_ == page_.streams[format::kSkinModesAll].attributes[0].values.size() &&
           news_ == count(format::kSkinNew) && ds_ == count(format::kSkinD) && es_ == count(format::kSkinE);
  }

 private:
  int32_t next(uint32_t stream, size_t& at) { return page_.streams[stream].attributes[0].values.at(at++); }
  int32_t nextDifference() {
    const int32_t low = lowOf(page_);
    return next(format::kSkinD, ds_) * (1 << low) + static_cast<int32_t>(low_bits_.read(low));
  }
  size_t count(uint32_t stream) const { return page_.streams[stream].attributes[0].values.size(); }

  static QuantizedSkin sorted(const std::vector<uint16_t>& joints, const std::vector<int32_t>& weights) {
    std::vector<std::pair<int32_t, uint16_t>> order;
    for (size_t i = 0; i < joints.size(); ++i)
      if (weights[i] != 0) order.push_back({-weights[i], joints[i]});
    std::sort(order.begin(), order.end());
    QuantizedSkin skin;
    for (const auto& [negative, joint] : order) {
      EXPECT_LT(negative, 0);
      skin.joint[skin.count] = joint;
      skin.weight[skin.count++] = static_cast<uint16_t>(-negative);
    }
    return skin;
  }

  const PageData& page_;
  test::BitReader low_bits_;
  size_t modes_ = 0, news_ = 0, ds_ = 0, es_ = 0;
};

PageData emptyPage() { return makePage(format::kSplitPage, {false, false, 0, 0}); }

std::vector<int32_t> valuesOf(const PageData& page, uint32_t stream) {
  return page.streams[stream].attributes[0].values;
}

const format::RingNeighbours kNoNeighbours{};
const SkinRing kNoRing{kNoNeighbours, {}};

/// Without neighbours to predict from, on a page of its own: the differences are the stream's values.
void encodeAlone(const QuantizedSkin& parent, const QuantizedSkin& a, const QuantizedSkin& b, int32_t t8,
                 PageData& page) {
  Residuals residuals;
  encodeSkins(parent, a, b, t8, kOne, kNoRing, page.streams[format::kSkinModesAll], page, residuals);
  residuals.finish(page);
}

/// A difference with the low bits that its page has.
std::vector<int32_t> differences(const PageData& page) {
  test::BitReader low_bits(page.low_bits[format::kLowSkins]);
  std::vector<int32_t> values = valuesOf(page, format::kSkinD);
  const int32_t low = lowOf(page);
  for (int32_t& value : values) value = value * (1 << low) + static_cast<int32_t>(low_bits.read(low));
  return values;
}

int32_t onlyMode(const PageData& page) { return page.streams[format::kSkinModesAll].attributes[0].values.at(0); }

TEST(SkinCode, ChildrenLikeTheirParentCostOnlyTheMode) {
  const QuantizedSkin skin = skinOf({{3, 200}, {1, 55}});
  PageData page = emptyPage();
  encodeAlone(skin, skin, skin, 4, page);
  EXPECT_EQ(onlyMode(page), format::kSkinSame);
  for (uint32_t stream : {format::kSkinD, format::kSkinE, format::kSkinNew})
    EXPECT_TRUE(valuesOf(page, stream).empty());
}

TEST(SkinCode, AParentBetweenItsChildrenNeedsOnlyTheirDifference) {
  // The parent halfway: b = (0: 155, 1: 100), a = (0: 55, 1: 200).
  const QuantizedSkin b = skinOf({{0, 155}, {1, 100}}), a = skinOf({{1, 200}, {0, 55}}),
                      parent = skinOf({{1, 150}, {0, 105}});
  PageData page = emptyPage();
  encodeAlone(parent, a, b, 4, page);
  EXPECT_EQ(onlyMode(page), format::kSkinRule);
  EXPECT_EQ(valuesOf(page, format::kSkinNew), std::vector<int32_t>{0});
  EXPECT_EQ(differences(page), std::vector<int32_t>{100});  // of joint 1, the parent's first
  EXPECT_TRUE(valuesOf(page, format::kSkinE).empty());
}

TEST(SkinCode, AParentElsewhereNeedsTheWayToChildBToo) {
  const QuantizedSkin b = skinOf({{0, 155}, {1, 100}}), a = skinOf({{1, 200}, {0, 55}}),
                      parent = skinOf({{1, 250}, {0, 5}});
  PageData page = emptyPage();
  encodeAlone(parent, a, b, 4, page);
  EXPECT_EQ(onlyMode(page), format::kSkinFree);
  EXPECT_EQ(differences(page), std::vector<int32_t>{100});
  EXPECT_EQ(valuesOf(page, format::kSkinE), std::vector<int32_t>{100 - 250});
}

TEST(SkinCode, JointsThatTheParentLacksAreNamedInAscendingOrder) {
  const QuantizedSkin a = skinOf({{9, 128}, {2, 127}}), b = skinOf({{5, 255}}), parent = skinOf({{2, 255}});
  PageData page = emptyPage();
  encodeAlone(parent, a, b, 0, page);
  EXPECT_EQ(valuesOf(page, format::kSkinNew), (std::vector<int32_t>{2, 5, 9}));
}

TEST(SkinCode, JointsOfTheRingAreNamedByTheirPlaceThere) {
  const QuantizedSkin around[] = {skinOf({{9, 200}, {2, 55}}), skinOf({{5, 128}, {7, 127}}), skinOf({{7, 255}})};
  format::RingNeighbours neighbours;
  for (uint32_t i = 0; i < 3; ++i) neighbours.wedge[i] = i, neighbours.r[i] = {1, 2, 3};
  neighbours.count = 3;
  const SkinRing ring{neighbours, [&](uint32_t wedge) -> const QuantizedSkin& { return around[wedge]; }};
  const QuantizedSkin a = skinOf({{9, 128}, {4, 127}}), b = skinOf({{5, 255}}), parent = skinOf({{2, 255}});
  PageData page = emptyPage();
  Residuals residuals;
  encodeSkins(parent, a, b, 0, kOne, ring, page.streams[format::kSkinModesAll], page, residuals);
  // By their greatest weight 7, 9 and 5 stand at 0, 1 and 2; joint 4 is not among them and comes as 3 + 4.
  EXPECT_EQ(valuesOf(page, format::kSkinNew), (std::vector<int32_t>{3, 1, 2, 7}));
}

TEST(SkinCode, OneJointInAllCostsNoNumbers) {
  const QuantizedSkin a = skinOf({{4, 255}}), parent = skinOf({{7, 255}});
  PageData page = emptyPage();
  encodeAlone(parent, a, a, 4, page);
  EXPECT_EQ(valuesOf(page, format::kSkinNew), (std::vector<int32_t>{1, 4}));
  const Children children = SkinReader(page).read(parent, 4);
  EXPECT_EQ(children.a, a);
  EXPECT_EQ(children.b, a);
}

TEST(SkinCode, EverySkinComesBack) {
  test::Random random(21);
  uint32_t modes[3] = {0, 0, 0};
  PageData page = emptyPage();
  Residuals residuals;
  struct Split {
    QuantizedSkin parent, a, b;
    int32_t t8;
  };
  std::vector<Split> splits;
  for (int i = 0; i < 5000; ++i) {
    const uint32_t joints = 1 + random.below(20), cap = 1 + random.below(8);
    Split split;
    split.b = test::randomSkin(random, joints, cap, kOne);
    split.a = random.chance(30) ? split.b : test::randomSkin(random, joints, cap, kOne);
    split.t8 = random.between(0, 8);
    switch (random.below(3)) {
      case 0:
        split.parent = split.b;
        break;
      case 1:
        split.parent = test::randomSkin(random, joints, cap, kOne);
        break;
      default:
        split.parent = interpolateSkin(split.b, split.a, split.t8, kOne, cap);
        break;
    }
    encodeSkins(split.parent, split.a, split.b, split.t8, kOne, kNoRing, page.streams[format::kSkinModesAll], page,
                residuals);
    ++modes[page.streams[format::kSkinModesAll].attributes[0].values.back()];
    splits.push_back(split);
  }
  residuals.finish(page);
  SkinReader reader(page);
  for (const Split& split : splits) {
    const Children children = reader.read(split.parent, split.t8);
    ASSERT_EQ(children.a, split.a);
    ASSERT_EQ(children.b, split.b);
  }
  EXPECT_TRUE(reader.atEnd());
  for (uint32_t count : modes) EXPECT_GT(count, 100u);
}

}  // namespace
}  // namespace lithe::bake
