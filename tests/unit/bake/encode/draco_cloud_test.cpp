// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// What encodeCloud() writes, libdraco itself reads back.
#include "draco_cloud.h"

#include <gtest/gtest.h>

#include "lithe/bake/model.h"
#include "page_reader.h"
#include "random_columns.h"

namespace lithe::bake {
namespace {

std::vector<uint8_t> componentsOf(const CloudColumns& cloud) {
  std::vector<uint8_t> components;
  for (const CloudColumn& column : cloud.columns) components.push_back(static_cast<uint8_t>(column.components));
  return components;
}

void expectBeginning(const CloudColumns& cloud, const std::vector<uint8_t>& bytes) {
  const std::vector<uint8_t> beginning = cloudBeginning(cloud.records, componentsOf(cloud));
  std::vector<uint8_t> whole = beginning;
  test::append(whole, withoutBeginning(bytes, beginning));
  EXPECT_EQ(whole, bytes);
}

void expectRoundTrip(const CloudColumns& cloud) {
  const std::vector<uint8_t> bytes = encodeCloud(cloud);
  std::vector<std::vector<int32_t>> columns = test::columnsOfCloud(bytes);
  ASSERT_EQ(columns.size(), cloud.columns.size());
  expectBeginning(cloud, bytes);
  for (size_t i = 0; i < columns.size(); ++i) {
    if (cloud.columns[i].is_unsigned)
      for (int32_t& value : columns[i]) value = test::unsignedOf(value);
    ASSERT_EQ(columns[i], cloud.columns[i].values) << "column " << i;
  }
}

TEST(DracoCloud, BeginningIsWhatThePageSays) {
  EXPECT_EQ(cloudBeginning(0x1234567, {3, 1}),
            (std::vector<uint8_t>{'D', 'R', 'A', 'C', 'O', 2, 3, 0, 0, 0, 0, 0x67, 0x45, 0x23, 1, 1, 2,  //
                                  4,   5,   3,   0,   0,   4, 5, 1, 0, 1, 1, 1}));
  const std::vector<uint8_t> most(127, 4);
  EXPECT_EQ(cloudBeginning(9, most), test::cloudBeginning(9, most));
}

TEST(DracoCloud, AnotherBeginningIsRefused) {
  const std::vector<uint8_t> cloud = encodeCloud({1, {{1, false, {7}}}}), beginning = cloudBeginning(1, {1});
  for (size_t at = 0; at < beginning.size(); ++at) {
    std::vector<uint8_t> other = cloud;
    other[at] ^= 1;
    EXPECT_THROW(withoutBeginning(other, beginning), Error) << at;
  }
  EXPECT_THROW(withoutBeginning({'D', 'R'}, beginning), Error);
}

TEST(DracoCloud, OrderOfRecordsIsKept) {
  expectRoundTrip({5, {{1, false, {3, -1, 3, 0, -100000}}, {2, true, {1, 2, 0, 0, 9, 8, 1, 1, 400000, 7}}}});
}

TEST(DracoCloud, ExtremesOfBothRanges) {
  expectRoundTrip({2, {{1, false, {-(1 << 18), (1 << 18) - 1}}, {1, true, {0, (1 << 19) - 1}}}});
  expectRoundTrip({1, {{4, false, {-(1 << 18), -(1 << 18), (1 << 18) - 1, 0}}}});
}

TEST(DracoCloud, RandomColumns) {
  test::Random random(11);
  for (int round = 0; round < 60; ++round) {
    CloudColumns cloud;
    cloud.records = random.octave(2000);
    cloud.raw = random.chance(20);
    const uint32_t count = 1 + random.below(5);
    for (uint32_t c = 0; c < count; ++c) {
      CloudColumn column;
      column.components = 1 + random.below(4);
      column.is_unsigned = random.chance(50);
      const auto shape = static_cast<test::Shape>(random.below(static_cast<uint32_t>(test::Shape::kShapeCount)));
      column.values = test::randomColumn(random, shape, cloud.records, column.components);
      if (column.is_unsigned)
        for (int32_t& value : column.values) value = value < 0 ? -(value + 1) : value;
      cloud.columns.push_back(column);
    }
    expectRoundTrip(cloud);
    if (HasFatalFailure()) return;
  }
}

TEST(DracoCloud, SameColumnsSameBytes) {
  test::Random random(12);
  const CloudColumns cloud{500, {{3, false, test::randomColumn(random, test::Shape::kBell, 500, 3)}}};
  EXPECT_EQ(encodeCloud(cloud), encodeCloud(cloud));
}

void expectRefused(const CloudColumns& cloud, const std::string& sentence) {
  try {
    encodeCloud(cloud);
    FAIL() << "taken, but should say: " << sentence;
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), sentence);
  }
}

TEST(DracoCloud, RefusesInOneSentence) {
  expectRefused({0, {{1, false, {}}}}, "Draco cloud: no records; leave an empty cloud out");
  expectRefused({1, {}}, "Draco cloud: 0 columns; use 1 to 127");
  expectRefused({1, std::vector<CloudColumn>(128, {1, false, {0}})}, "Draco cloud: 128 columns; use 1 to 127");
  expectRefused({1, {{1, false, {0}}, {5, false, {0, 0, 0, 0, 0}}}}, "Draco cloud, column 1: 5 components; use 1 to 4");
  expectRefused({2, {{2, false, {1, 2, 3}}}},
                "Draco cloud, column 0: 3 values for 2 records of 2; give one value per record and component");
  expectRefused({1, {{1, false, {1 << 18}}}},
                "Draco cloud, column 0: the value 262144 is outside -262144..262143; split it into two columns");
  expectRefused({1, {{1, true, {-1}}}},
                "Draco cloud, column 0: the value -1 is outside 0..524287; split it into two columns");
}

}  // namespace
}  // namespace lithe::bake
