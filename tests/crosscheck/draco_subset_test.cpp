// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The runtime's own Draco reader against libdraco: same clouds, same numbers, and both what went in.
#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>
#include <draco/point_cloud/point_cloud.h>
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "draco_cloud.h"
#include "encode/draco_cloud.h"
#include "lithe/bake/model.h"
#include "random_columns.h"
#include "rans.h"

namespace lithe {
namespace {

using bake::CloudColumn;
using bake::CloudColumns;
using test::Random;
using test::Shape;

struct Settings {
  int speed = 5;
  int prediction = draco::PREDICTION_NONE;
  bool compressed = true;
};

int32_t attributeValue(const CloudColumn& column, size_t i) {
  return column.is_unsigned ? runtime::fromZigzag(static_cast<uint32_t>(column.values[i])) : column.values[i];
}

/// libdraco with every setting that leads into the subset; encodeCloud() uses some of them only.
std::vector<uint8_t> encodeWith(const CloudColumns& columns, const Settings& settings) {
  draco::PointCloud cloud;
  cloud.set_num_points(columns.records);
  for (const CloudColumn& column : columns.columns) {
    draco::GeometryAttribute layout;
    layout.Init(draco::GeometryAttribute::GENERIC, nullptr, static_cast<int8_t>(column.components), draco::DT_INT32,
                false, 4 * column.components, 0);
    const int id = cloud.AddAttribute(layout, true, columns.records);
    for (size_t i = 0; i < column.values.size(); ++i) {
      const int32_t value = attributeValue(column, i);
      cloud.attribute(id)->buffer()->Write(static_cast<int64_t>(4 * i), &value, 4);
    }
  }
  draco::ExpertEncoder encoder(cloud);
  encoder.SetEncodingMethod(draco::POINT_CLOUD_SEQUENTIAL_ENCODING);
  encoder.SetSpeedOptions(settings.speed, settings.speed);
  encoder.SetUseBuiltInAttributeCompression(settings.compressed);
  for (int id = 0; id < cloud.num_attributes(); ++id) {
    EXPECT_TRUE(encoder.SetAttributePredictionScheme(id, settings.prediction).ok());
  }
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  return {buffer.data(), buffer.data() + buffer.size()};
}

/// What a page holds of a cloud.
std::vector<uint8_t> streamOf(const std::vector<uint8_t>& cloud, const CloudColumns& columns) {
  std::vector<uint8_t> components;
  for (const CloudColumn& column : columns.columns) components.push_back(static_cast<uint8_t>(column.components));
  return bake::withoutBeginning(cloud, bake::cloudBeginning(columns.records, components));
}

std::vector<std::vector<int32_t>> decodeWithDraco(const std::vector<uint8_t>& bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodePointCloudFromBuffer(&buffer);
  EXPECT_TRUE(decoded.ok());
  std::vector<std::vector<int32_t>> columns;
  if (!decoded.ok()) return columns;
  const draco::PointCloud& cloud = *decoded.value();
  for (int id = 0; id < cloud.num_attributes(); ++id) {
    const draco::PointAttribute& attribute = *cloud.attribute(id);
    std::vector<int32_t> values(size_t{cloud.num_points()} * attribute.num_components());
    for (uint32_t i = 0; i < cloud.num_points(); ++i) {
      attribute.GetMappedValue(draco::PointIndex(i), &values[size_t{i} * attribute.num_components()]);
    }
    columns.push_back(std::move(values));
  }
  return columns;
}

/// What decodeCloud() needs for the clouds of this test, allocated once.
class Reader {
 public:
  explicit Reader(uint32_t max_records)
      : scratch_memory_(runtime::decodeScratchSize(max_records, SIZE_MAX) / 8 + 1),
        scratch_{scratch_memory_.data(), scratch_memory_.size() * 8} {}

  runtime::CloudResult read(const std::vector<uint8_t>& cloud, const CloudColumns& expected) {
    const std::vector<uint8_t> bytes = streamOf(cloud, expected);
    std::vector<runtime::ColumnSpec> specs;
    std::vector<int32_t*> outs;
    values.resize(expected.columns.size());
    for (size_t i = 0; i < expected.columns.size(); ++i) {
      const CloudColumn& column = expected.columns[i];
      specs.push_back({static_cast<uint8_t>(column.components),
                       column.is_unsigned ? runtime::ColumnKind::kUnsigned : runtime::ColumnKind::kSigned});
      values[i].assign(column.values.size(), -1);
      outs.push_back(values[i].data());
    }
    return runtime::decodeCloud(bytes.data(), bytes.size(), expected.records, specs.data(),
                                static_cast<uint32_t>(specs.size()), outs.data(), scratch_);
  }

  std::vector<std::vector<int32_t>> values;

 private:
  std::vector<uint64_t> scratch_memory_;
  runtime::DecodeScratch scratch_;
};

void makeUnsigned(CloudColumn& column) {
  column.is_unsigned = true;
  for (int32_t& value : column.values) value = value < 0 ? -2 * value - 1 : 2 * value;
}

CloudColumns randomCloud(Random& random, uint32_t max_records, uint32_t max_columns) {
  CloudColumns cloud;
  cloud.records = random.octave(max_records);
  cloud.columns.resize(1 + random.below(max_columns));
  for (CloudColumn& column : cloud.columns) {
    column.components = 1 + random.below(4);
    const Shape shape = static_cast<Shape>(random.below(static_cast<uint32_t>(Shape::kShapeCount)));
    column.values = test::randomColumn(random, shape, cloud.records, column.components);
    if (random.chance(40)) makeUnsigned(column);
  }
  return cloud;
}

/// Our reader gives the input; libdraco's does as well.
void expectSame(Reader& reader, const std::vector<uint8_t>& bytes, const CloudColumns& cloud) {
  ASSERT_EQ(runtime::CloudResult::kOk, reader.read(bytes, cloud));
  const std::vector<std::vector<int32_t>> theirs = decodeWithDraco(bytes);
  ASSERT_EQ(theirs.size(), cloud.columns.size());
  for (size_t c = 0; c < cloud.columns.size(); ++c) {
    const CloudColumn& column = cloud.columns[c];
    ASSERT_EQ(column.values, reader.values[c]) << "column " << c;
    for (size_t i = 0; i < column.values.size(); ++i) ASSERT_EQ(attributeValue(column, i), theirs[c][i]);
  }
}

class DracoSubsetSpeed : public testing::TestWithParam<int> {};

/// 11 speeds x 1500 clouds.
TEST_P(DracoSubsetSpeed, ReadsWhatLibdracoWrites) {
  Random random(100 + static_cast<uint64_t>(GetParam()));
  Reader reader(5000);
  for (int round = 0; round < 1500; ++round) {
    SCOPED_TRACE(round);
    const CloudColumns cloud = randomCloud(random, 5000, round % 10 == 0 ? 12 : 4);
    Settings settings;
    settings.speed = GetParam();
    settings.compressed = !random.chance(10);
    expectSame(reader, encodeWith(cloud, settings), cloud);
    if (HasFatalFailure()) return;
  }
}

TEST(DracoSubset, PredictedColumnsAreRefused) {
  Random random(23);
  Reader reader(5000);
  for (int round = 0; round < 100; ++round) {
    const CloudColumns cloud = randomCloud(random, 5000, 4);
    Settings settings;
    settings.prediction = draco::PREDICTION_DIFFERENCE;
    ASSERT_EQ(runtime::CloudResult::kForeign, reader.read(encodeWith(cloud, settings), cloud));
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, DracoSubsetSpeed, testing::Range(0, 11));

TEST(DracoSubsetBake, ReadsWhatTheBakeWrites) {
  Random random(7);
  Reader reader(3000);
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    CloudColumns cloud = randomCloud(random, 3000, 6);
    cloud.raw = random.chance(10);
    expectSame(reader, bake::encodeCloud(cloud), cloud);
    if (HasFatalFailure()) return;
  }
}

/// What decodeClouds() needs for a set of clouds.
struct Jobs {
  std::vector<std::vector<runtime::ColumnSpec>> specs;
  std::vector<std::vector<std::vector<int32_t>>> values;
  std::vector<std::vector<int32_t*>> outs;
  std::vector<runtime::CloudJob> jobs;

  Jobs(const std::vector<CloudColumns>& clouds, const std::vector<std::vector<uint8_t>>& bytes)
      : specs(clouds.size()), values(clouds.size()), outs(clouds.size()) {
    for (size_t i = 0; i < clouds.size(); ++i) {
      for (const CloudColumn& column : clouds[i].columns) {
        specs[i].push_back({static_cast<uint8_t>(column.components),
                            column.is_unsigned ? runtime::ColumnKind::kUnsigned : runtime::ColumnKind::kSigned});
        values[i].emplace_back(column.values.size(), -1);
      }
      for (std::vector<int32_t>& column : values[i]) outs[i].push_back(column.data());
      jobs.push_back({bytes[i].data(), bytes[i].size(), 0, clouds[i].records, specs[i].data(),
                      static_cast<uint32_t>(specs[i].size()), outs[i].data()});
    }
  }
};

/// Sets of clouds as a page has them, where some wait for their tags while others go on. Damaging one blames that one.
TEST(DracoSubset, SetsOfCloudsAreReadSideBySide) {
  Random random(19);
  std::vector<uint64_t> memory(runtime::decodeScratchSize(2000, SIZE_MAX) / 8 + 1);
  const runtime::DecodeScratch scratch = {memory.data(), memory.size() * 8};
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    std::vector<CloudColumns> clouds(1 + random.below(16));
    std::vector<std::vector<uint8_t>> bytes;
    for (CloudColumns& cloud : clouds) {
      cloud = randomCloud(random, 2000, 3);
      Settings settings;
      settings.speed = static_cast<int>(random.below(11));
      bytes.push_back(streamOf(encodeWith(cloud, settings), cloud));
    }
    Jobs set(clouds, bytes);
    const uint32_t count = static_cast<uint32_t>(clouds.size());
    ASSERT_EQ(runtime::CloudResult::kOk, runtime::decodeClouds(set.jobs.data(), count, scratch, nullptr));
    for (size_t i = 0; i < clouds.size(); ++i) {
      for (size_t c = 0; c < clouds[i].columns.size(); ++c) ASSERT_EQ(clouds[i].columns[c].values, set.values[i][c]);
    }
    const uint32_t damaged = random.below(count);
    uint32_t failed = count;
    --set.jobs[damaged].size;
    ASSERT_NE(runtime::CloudResult::kOk, runtime::decodeClouds(set.jobs.data(), count, scratch, &failed));
    ASSERT_EQ(damaged, failed);
  }
}

/// The paths that a one-column cloud took, read off its stream.
struct Paths {
  std::set<uint32_t> precisions;
  std::set<uint32_t> plain_bytes;
  uint32_t tagged = 0;

  void note(const std::vector<uint8_t>& bytes) {
    const uint8_t compressed = bytes[1], how = bytes[2];  // after the prediction
    if (compressed == 0)
      plain_bytes.insert(how);
    else if (how == 0)
      ++tagged;
    else
      precisions.insert(runtime::ransPrecision(bytes[3]));
  }
};

TEST(DracoSubsetCoverage, EveryPrecisionAndSchemeOccurs) {
  Random random(11);
  Reader reader(1 << 16);
  Paths paths;
  for (int round = 0; round < 400; ++round) {
    SCOPED_TRACE(round);
    CloudColumns cloud;
    cloud.records = random.chance(50) ? 1 << 16 : random.octave(1 << 16);
    CloudColumn column;
    column.values = test::randomColumn(random, random.chance(50) ? Shape::kUniform : Shape::kBell, cloud.records, 1);
    cloud.columns.push_back(column);
    Settings settings;
    settings.speed = static_cast<int>(random.below(11));
    settings.compressed = round % 8 != 0;
    const std::vector<uint8_t> bytes = encodeWith(cloud, settings);
    paths.note(streamOf(bytes, cloud));
    expectSame(reader, bytes, cloud);
    if (HasFatalFailure()) return;
  }
  EXPECT_EQ((std::set<uint32_t>{12, 13, 15, 16, 18, 19, 20}), paths.precisions);
  EXPECT_EQ((std::set<uint32_t>{1, 2, 3}), paths.plain_bytes);
  EXPECT_GT(paths.tagged, 20u);
}

/// An unsigned column leaves no symbol out, so it never costs more than the same numbers as a signed column.
TEST(DracoSubsetBake, UnsignedColumnsAreSmaller) {
  Random random(13);
  CloudColumns cloud;
  cloud.records = 1000;
  cloud.columns.resize(1);
  for (uint32_t i = 0; i < cloud.records; ++i)
    cloud.columns[0].values.push_back(static_cast<int32_t>(random.octave(64)));
  const size_t as_signed = bake::encodeCloud(cloud).size();
  cloud.columns[0].is_unsigned = true;
  EXPECT_LT(bake::encodeCloud(cloud).size() + 20, as_signed);
}

TEST(DracoSubsetBake, RawBytesCostOneByteEach) {
  Random random(17);
  CloudColumns cloud;
  cloud.records = 4096;
  cloud.raw = true;
  cloud.columns.resize(1);
  cloud.columns[0].is_unsigned = true;
  for (uint32_t i = 0; i < cloud.records; ++i) cloud.columns[0].values.push_back(random.between(0, 255));
  EXPECT_EQ(bake::encodeCloud(cloud).size(), 4096u + 26u);
}

TEST(DracoSubsetBake, RefusesWhatHasNoEncoding) {
  CloudColumns cloud;
  cloud.columns.push_back({1, false, {}});
  EXPECT_THROW(bake::encodeCloud(cloud), bake::Error);  // no records
  cloud.records = 2;
  EXPECT_THROW(bake::encodeCloud(cloud), bake::Error);  // no values
  cloud.columns[0].values = {0, 1 << 18};
  EXPECT_THROW(bake::encodeCloud(cloud), bake::Error);  // too large
  cloud.columns[0].is_unsigned = true;
  EXPECT_NO_THROW(bake::encodeCloud(cloud));
  cloud.columns[0].values = {0, -1};
  EXPECT_THROW(bake::encodeCloud(cloud), bake::Error);  // negative
  cloud.columns[0].values = {0, 1};
  cloud.columns[0].components = 5;
  EXPECT_THROW(bake::encodeCloud(cloud), bake::Error);
  cloud.columns.clear();
  EXPECT_THROW(bake::encodeCloud(cloud), bake::Error);
}

}  // namespace
}  // namespace lithe
