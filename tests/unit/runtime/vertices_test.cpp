// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "hand_made_asset.h"
#include "vertex_formats.h"

namespace lithe::test {
namespace {

constexpr uint8_t kUntouched = 0xa5;

struct Written {
  std::vector<uint8_t> bytes;
  lithe_result result;
};

Written write(const lithe_asset* asset, const lithe_vertex_layout& layout, uint32_t first, uint32_t count) {
  Written w{std::vector<uint8_t>(size_t{count} * layout.stride, kUntouched), LITHE_OK};
  w.result = lithe_asset_write_vertices(asset, &layout, first, count, w.bytes.data(), w.bytes.size());
  return w;
}

template <typename T>
T load(const uint8_t* p, uint32_t index = 0) {
  T value;
  std::memcpy(&value, p + index * sizeof(T), sizeof(T));
  return value;
}

lithe_vertex_layout emptyLayout(uint32_t stride) {
  lithe_vertex_layout layout = {};
  layout.struct_size = sizeof layout;
  layout.stride = stride;
  layout.influences = 8;
  return layout;
}

lithe_attribute at(lithe_format format, uint32_t offset) {
  return {static_cast<uint16_t>(format), static_cast<uint16_t>(offset)};
}

class Vertices : public testing::Test {
 protected:
  void open(const AssetShape& shape) {
    hand_.emplace_back(shape);
    asset_.reset(hand().open().release());
    ASSERT_TRUE(asset_);
    lithe_asset_describe(asset_.get(), &info_);
  }
  const HandMade& hand() const { return hand_.back(); }
  uint32_t count() const { return info_.vertex_count; }
  const HandNode& node(uint32_t wedge) const { return hand().nodes[hand().wedges[wedge].node]; }
  const uint16_t* attributes(uint32_t wedge) const { return hand().wedges[wedge].attributes.data(); }
  lithe_result result(const lithe_vertex_layout& layout) const { return write(asset_.get(), layout, 0, 2).result; }

  std::vector<HandMade> hand_;
  std::unique_ptr<lithe_asset, void (*)(lithe_asset*)> asset_{nullptr, lithe_asset_close};
  lithe_asset_info info_ = {};
};

TEST_F(Vertices, PositionsAreTheGridsInBothFormats) {
  open({});
  lithe_vertex_layout layout = emptyLayout(20);
  layout.position = at(LITHE_FORMAT_F32, 0);
  lithe_vertex_layout snorm = emptyLayout(8);
  snorm.position = at(LITHE_FORMAT_SNORM16, 0);
  const Written floats = write(asset_.get(), layout, 0, count()), shorts = write(asset_.get(), snorm, 0, count());
  ASSERT_EQ(floats.result, LITHE_OK);
  ASSERT_EQ(shorts.result, LITHE_OK);
  const float origin[3] = {-1.5f, 2.0f, 0.125f};
  for (uint32_t w = 0; w < count(); ++w)
    for (uint32_t c = 0; c < 3; ++c) {
      const float expected = origin[c] + 0x1p-9f * static_cast<float>(node(w).position[c]);
      ASSERT_EQ(load<float>(&floats.bytes[w * 20], c), expected);
      const double snorm_value = load<int16_t>(&shorts.bytes[w * 8], c) / 32767.0;
      ASSERT_NEAR(info_.position_offset[c] + info_.position_scale * snorm_value, expected, 1e-5);
      ASSERT_EQ(load<int16_t>(&shorts.bytes[w * 8], 3), 32767);
    }
}

TEST_F(Vertices, SixteenBitPositionsStayWithinSnorm) {
  AssetShape shape;
  shape.position_bits = 16;
  open(shape);
  asset_->decoded.node_position[0] = 0;
  lithe_vertex_layout layout = emptyLayout(8);
  layout.position = at(LITHE_FORMAT_SNORM16, 0);
  const Written w = write(asset_.get(), layout, 0, 1);
  EXPECT_EQ(load<int16_t>(w.bytes.data()), -32767);
}

TEST_F(Vertices, NormalsAndTangentsPointTheSameWayInEveryFormat) {
  for (const uint32_t bits : {4u, 10u, 15u}) {
    AssetShape shape;
    shape.normal_bits = bits;
    open(shape);
    const int32_t center = format::octahedralCenter(bits);
    lithe_vertex_layout f32 = emptyLayout(28), snorm16 = emptyLayout(8), snorm8 = emptyLayout(8);
    f32.normal = at(LITHE_FORMAT_F32, 0), f32.tangent = at(LITHE_FORMAT_F32, 12);
    snorm16.normal = at(LITHE_FORMAT_SNORM16, 4), snorm16.tangent = at(LITHE_FORMAT_SNORM16, 0);
    snorm8.normal = at(LITHE_FORMAT_SNORM8, 0), snorm8.tangent = at(LITHE_FORMAT_SNORM8, 4);
    const Written a = write(asset_.get(), f32, 0, count()), b = write(asset_.get(), snorm16, 0, count()),
                  c = write(asset_.get(), snorm8, 0, count());
    for (uint32_t w = 0; w < count(); ++w) {
      const uint16_t* p = attributes(w);
      float normal[3], tangent[3];
      runtime::octahedralUnit(p[0], p[1], center, normal);
      runtime::octahedralUnit(p[2], p[3], center, tangent);
      for (uint32_t k = 0; k < 3; ++k) {
        ASSERT_EQ(load<float>(&a.bytes[w * 28], k), normal[k]);
        ASSERT_EQ(load<float>(&a.bytes[w * 28], 3 + k), tangent[k]);
        ASSERT_NEAR(load<int8_t>(&c.bytes[w * 8], k), 127 * normal[k], 0.501);
        ASSERT_NEAR(load<int8_t>(&c.bytes[w * 8], 4 + k), 127 * tangent[k], 0.501);
      }
      ASSERT_EQ(load<float>(&a.bytes[w * 28], 6), p[4] ? 1.0f : -1.0f);
      ASSERT_EQ(load<int8_t>(&c.bytes[w * 8], 3), 0);
      ASSERT_EQ(load<int8_t>(&c.bytes[w * 8], 7), p[4] ? 127 : -127);
      ASSERT_EQ(load<int16_t>(&b.bytes[w * 8], 2), runtime::octahedralSnorm16(p[0], center));
      ASSERT_EQ(load<int16_t>(&b.bytes[w * 8], 3), runtime::octahedralSnorm16(p[1], center));
      ASSERT_EQ(load<int16_t>(&b.bytes[w * 8], 0), runtime::octahedralSnorm16(p[2], center));
      ASSERT_EQ(load<int16_t>(&b.bytes[w * 8], 1), runtime::handedSnorm16(p[3], center, p[4] != 0));
    }
  }
}

TEST_F(Vertices, UvsFollowThePartsGrid) {
  open({});
  lithe_vertex_layout layout = emptyLayout(16);
  layout.uv[0] = at(LITHE_FORMAT_F32, 8);
  layout.uv[1] = at(LITHE_FORMAT_F16, 0);
  lithe_vertex_layout unorm = emptyLayout(4);
  unorm.uv[1] = at(LITHE_FORMAT_UNORM16, 0);
  const Written w = write(asset_.get(), layout, 0, count()), u = write(asset_.get(), unorm, 0, count());
  ASSERT_EQ(u.result, LITHE_OK);
  for (uint32_t i = 0; i < count(); ++i)
    for (uint32_t k = 0; k < 2; ++k) {
      const float offset = 0.25f + (k == 0 ? 0.01f * static_cast<float>(hand().wedges[i].part) : 0.0f);
      const float uv0 = offset + 0x1p-13f * attributes(i)[5 + k], uv1 = offset + 0x1p-13f * attributes(i)[7 + k];
      ASSERT_EQ(load<float>(&w.bytes[16 * i], 2 + k), uv0);
      ASSERT_EQ(load<uint16_t>(&w.bytes[16 * i], k), runtime::toHalf(uv1));
      ASSERT_NEAR(load<uint16_t>(&u.bytes[4 * i], k), uv1 * 65535.0, 0.51);
    }
}

TEST_F(Vertices, UvsOutsideTheUnitSquareHaveNoUnorm) {
  AssetShape shape;
  shape.uv_offset = 0.75f;  // up to 1.25
  open(shape);
  lithe_vertex_layout layout = emptyLayout(4);
  layout.uv[0] = at(LITHE_FORMAT_UNORM16, 0);
  const Written w = write(asset_.get(), layout, 0, count());
  EXPECT_EQ(w.result, LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(w.bytes, std::vector<uint8_t>(w.bytes.size(), kUntouched));
}

TEST_F(Vertices, ColoursInBothFormats) {
  open({});
  lithe_vertex_layout layout = emptyLayout(20);
  layout.color[0] = at(LITHE_FORMAT_F32, 4);
  lithe_vertex_layout bytes = emptyLayout(4);
  bytes.color[0] = at(LITHE_FORMAT_UNORM8, 0);
  const Written f = write(asset_.get(), layout, 0, count()), u = write(asset_.get(), bytes, 0, count());
  for (uint32_t i = 0; i < count(); ++i)
    for (uint32_t k = 0; k < 4; ++k) {
      const uint16_t color = attributes(i)[9 + k];
      ASSERT_EQ(load<float>(&f.bytes[20 * i], 1 + k), color / 255.0f);
      ASSERT_EQ(u.bytes[4 * i + k], color);
    }
}

TEST_F(Vertices, SkinsInEveryFormatAndPrecision) {
  for (const uint32_t weight_bits : {4u, 8u, 11u, 16u})
    for (const uint32_t influences : {4u, 7u}) {
      AssetShape shape;
      shape.weight_bits = weight_bits;
      open(shape);
      lithe_vertex_layout layout = emptyLayout(7 * influences + 1);
      layout.influences = influences;
      layout.weights = at(LITHE_FORMAT_F32, 0);
      layout.joints = at(LITHE_FORMAT_U16, 4 * influences);
      lithe_vertex_layout narrow = emptyLayout(3 * influences);
      narrow.influences = influences;
      narrow.joints = at(LITHE_FORMAT_U8, 2 * influences);
      narrow.weights = at(LITHE_FORMAT_UNORM16, 0);
      lithe_vertex_layout bytes = emptyLayout(influences);
      bytes.influences = influences;
      bytes.weights = at(LITHE_FORMAT_UNORM8, 0);
      const Written f = write(asset_.get(), layout, 0, count()), s = write(asset_.get(), narrow, 0, count()),
                    b = write(asset_.get(), bytes, 0, count());
      ASSERT_EQ(f.result, LITHE_OK);
      ASSERT_EQ(s.result, LITHE_OK);
      ASSERT_EQ(b.result, LITHE_OK);
      const double one = (1u << weight_bits) - 1;
      for (uint32_t i = 0; i < count(); ++i) {
        const runtime::NodeSkin& skin = hand().skinOf(i);
        uint32_t sum8 = 0, sum16 = 0;
        for (uint32_t k = 0; k < influences; ++k) {
          const bool used = k < skin.count;
          const double weight = used ? skin.weight[k] / one : 0;
          const uint16_t joint = used ? skin.joint[k] : 0;
          const uint8_t* v = &f.bytes[i * layout.stride];
          const uint8_t* n = &s.bytes[i * narrow.stride];
          ASSERT_EQ(load<float>(v, k), static_cast<float>(weight));
          ASSERT_EQ(load<uint16_t>(v + 4 * influences, k), joint);
          ASSERT_EQ(n[2 * influences + k], joint);
          ASSERT_LT(std::abs(load<uint16_t>(n, k) - 65535 * weight), 1.0);
          ASSERT_LT(std::abs(b.bytes[i * influences + k] - 255 * weight), 1.0);
          sum16 += load<uint16_t>(n, k);
          sum8 += b.bytes[i * influences + k];
        }
        ASSERT_EQ(sum16, 65535u);
        ASSERT_EQ(sum8, 255u);
      }
    }
}

// Any order of attributes with gaps between them, in pieces of any size, equals one vertex at a time.
TEST_F(Vertices, RangesAndGapsAreExact) {
  open({});
  lithe_vertex_layout layout = emptyLayout(600);  // few vertices to a block
  layout.influences = 5;
  layout.position = at(LITHE_FORMAT_F32, 520);
  layout.normal = at(LITHE_FORMAT_SNORM8, 4);
  layout.uv[1] = at(LITHE_FORMAT_F16, 8);
  layout.weights = at(LITHE_FORMAT_UNORM8, 100);
  layout.joints = at(LITHE_FORMAT_U8, 95);
  const Written all = write(asset_.get(), layout, 0, count());
  ASSERT_EQ(all.result, LITHE_OK);
  for (uint32_t i = 0; i < count(); ++i)
    for (uint32_t b = 0; b < 600; ++b) {
      const bool covered = (b >= 4 && b < 12) || (b >= 95 && b < 105) || (b >= 520 && b < 532);
      if (!covered) {
        ASSERT_EQ(all.bytes[600 * i + b], kUntouched) << b;
      }
    }
  for (uint32_t first = 0; first < count(); first += 7)
    for (const uint32_t n : {1u, 13u, 14u, 40u}) {
      if (first + n > count()) continue;
      const Written some = write(asset_.get(), layout, first, n);
      ASSERT_TRUE(std::equal(some.bytes.begin(), some.bytes.end(), all.bytes.begin() + 600 * first));
    }
}

TEST_F(Vertices, DefaultLayoutHasEverythingPackedAndIsAccepted) {
  open({});
  const lithe_vertex_layout layout = lithe_vertex_layout_default(asset_.get());
  EXPECT_EQ(layout.struct_size, sizeof layout);
  EXPECT_EQ(layout.stride, 12u + 4 + 4 + 2 * 4 + 4 + 4 + 4);
  EXPECT_EQ(layout.influences, 4u);
  EXPECT_EQ(layout.joints.format, LITHE_FORMAT_U8);
  EXPECT_EQ(write(asset_.get(), layout, 0, count()).result, LITHE_OK);

  AssetShape shape;
  shape.joints = 300, shape.max_influences = 6, shape.tangents = false, shape.color_sets = 0, shape.uv_sets = 0;
  open(shape);
  const lithe_vertex_layout wide = lithe_vertex_layout_default(asset_.get());
  EXPECT_EQ(wide.stride, 12u + 4 + 16 + 8);
  EXPECT_EQ(wide.joints.format, LITHE_FORMAT_U16);
  EXPECT_EQ(write(asset_.get(), wide, 0, count()).result, LITHE_OK);
}

TEST_F(Vertices, RefusesLayoutsThatCannotBe) {
  AssetShape shape;
  shape.joints = 300;
  open(shape);
  const lithe_vertex_layout good = lithe_vertex_layout_default(asset_.get());
  ASSERT_EQ(result(good), LITHE_OK);
  auto refused = [&](auto change) {
    lithe_vertex_layout layout = good;
    change(layout);
    return result(layout) == LITHE_ERROR_INVALID_ARGUMENT;
  };
  EXPECT_TRUE(refused([](auto& l) { l.struct_size -= 4; }));
  EXPECT_TRUE(refused([](auto& l) { l.stride -= 1; }));
  EXPECT_TRUE(refused([](auto& l) { l.stride = 0; }));
  EXPECT_TRUE(refused([](auto& l) { l.stride = 2049; }));
  EXPECT_TRUE(refused([](auto& l) { l.influences = 3; }));
  EXPECT_TRUE(refused([](auto& l) { l.influences = 9; }));
  EXPECT_TRUE(refused([](auto& l) { l.position.offset = 2; }));              // not aligned
  EXPECT_TRUE(refused([](auto& l) { l.normal.offset = 0; }));                // over the position
  EXPECT_TRUE(refused([](auto& l) { l.joints.format = LITHE_FORMAT_U8; }));  // 300 joints
  EXPECT_TRUE(refused([](auto& l) { l.color[1] = {LITHE_FORMAT_UNORM8, 0}; }));
  EXPECT_TRUE(refused([](auto& l) { l.uv[2] = {LITHE_FORMAT_F16, 0}; }));
  for (const uint16_t f : {uint16_t{LITHE_FORMAT_U8}, uint16_t{9}, uint16_t{65535}}) {
    EXPECT_TRUE(refused([&](auto& l) { l.position.format = f; }));
    EXPECT_TRUE(refused([&](auto& l) { l.normal.format = f; }));
    EXPECT_TRUE(refused([&](auto& l) { l.tangent.format = f; }));
    EXPECT_TRUE(refused([&](auto& l) { l.uv[0].format = f; }));
    EXPECT_TRUE(refused([&](auto& l) { l.color[0].format = f; }));
    EXPECT_TRUE(refused([&](auto& l) { l.weights.format = f; }));
  }
}

TEST_F(Vertices, BadArguments) {
  open({});
  const lithe_vertex_layout layout = lithe_vertex_layout_default(asset_.get());
  std::vector<uint8_t> bytes(layout.stride * 2);
  const lithe_asset* a = asset_.get();
  EXPECT_EQ(lithe_asset_write_vertices(nullptr, &layout, 0, 2, bytes.data(), bytes.size()),
            LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_vertices(a, nullptr, 0, 2, bytes.data(), bytes.size()), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_vertices(a, &layout, 0, 2, nullptr, bytes.size()), LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_vertices(a, &layout, count() - 1, 2, bytes.data(), bytes.size()),
            LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_vertices(a, &layout, 0xffffffffu, 2, bytes.data(), bytes.size()),
            LITHE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(lithe_asset_write_vertices(a, &layout, 0, 2, bytes.data(), bytes.size() - 1), LITHE_ERROR_BUFFER_TOO_SMALL);
  EXPECT_EQ(lithe_asset_write_vertices(a, &layout, 5, 0, nullptr, 0), LITHE_OK);
  ASSERT_EQ(lithe_asset_evict(asset_.get(), 0), LITHE_OK);
  EXPECT_EQ(lithe_asset_write_vertices(a, &layout, count() - 2, 2, bytes.data(), bytes.size()),
            LITHE_ERROR_NOT_RESIDENT);
  EXPECT_EQ(lithe_asset_write_vertices(a, &layout, 0, 2, bytes.data(), bytes.size()), LITHE_OK);
  EXPECT_EQ(lithe_vertex_layout_default(nullptr).struct_size, 0u);
}

}  // namespace
}  // namespace lithe::test
