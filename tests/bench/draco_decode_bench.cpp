// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The runtime's Draco reader against libdraco's, on the same clouds, one thread. Columns are shaped like a page's:
// flags, ranks, residuals. Run with --benchmark_repetitions=9 --benchmark_report_aggregates_only and compare medians.
#include <benchmark/benchmark.h>
#include <draco/compression/decode.h>
#include <draco/point_cloud/point_cloud.h>

#include <cstdlib>

#include "draco_cloud.h"
#include "encode/draco_cloud.h"
#include "random_columns.h"

namespace lithe {
namespace {

using bake::CloudColumn;
using bake::CloudColumns;

CloudColumn exponentialColumn(test::Random& random, uint32_t records, uint32_t components, double mean,
                              bool is_unsigned) {
  CloudColumn column{components, is_unsigned, {}};
  for (uint32_t i = 0; i < records * components; ++i) {
    const int32_t value = test::exponential(random, mean);
    column.values.push_back(is_unsigned ? std::abs(value) : value);
  }
  return column;
}

CloudColumn flagColumn(test::Random& random, uint32_t records, uint32_t percent) {
  CloudColumn column{1, true, {}};
  for (uint32_t i = 0; i < records; ++i) column.values.push_back(random.chance(percent));
  return column;
}

/// Ten attributes, sixteen components: what a split of a textured, skinned character amounts to.
CloudColumns splitColumns(uint32_t records) {
  test::Random random(records);
  CloudColumns cloud;
  cloud.records = records;
  cloud.columns.push_back(flagColumn(random, records, 40));
  cloud.columns.push_back(exponentialColumn(random, records, 1, 1.5, true));    // cut rank
  cloud.columns.push_back(exponentialColumn(random, records, 3, 20.0, false));  // difference of the children
  cloud.columns.push_back(exponentialColumn(random, records, 1, 2.0, true));    // placement
  cloud.columns.push_back(exponentialColumn(random, records, 2, 9.0, false));   // normal
  cloud.columns.push_back(exponentialColumn(random, records, 2, 30.0, false));  // uv
  cloud.columns.push_back(exponentialColumn(random, records, 3, 6.0, false));   // weights
  cloud.columns.push_back(flagColumn(random, records, 5));
  cloud.columns.push_back(exponentialColumn(random, records, 1, 0.4, true));  // seams
  cloud.columns.push_back(exponentialColumn(random, records, 1, 60.0, false));
  return cloud;
}

size_t valuesIn(const CloudColumns& cloud) {
  size_t count = 0;
  for (const CloudColumn& column : cloud.columns) count += column.values.size();
  return count;
}

/// The same columns as a page has them: each in a cloud of its own.
std::vector<CloudColumns> oneCloudEach(const CloudColumns& cloud) {
  std::vector<CloudColumns> clouds;
  for (const CloudColumn& column : cloud.columns) clouds.push_back({cloud.records, {column}, false});
  return clouds;
}

/// Clouds that are ready to be decoded again and again.
struct Prepared {
  std::vector<std::vector<uint8_t>> bytes;
  std::vector<std::vector<runtime::ColumnSpec>> specs;
  std::vector<std::vector<int32_t>> values;
  std::vector<std::vector<int32_t*>> outs;
  std::vector<runtime::CloudJob> jobs;
  std::vector<uint64_t> scratch_memory;
  size_t value_count = 0;

  explicit Prepared(const std::vector<CloudColumns>& clouds) {
    uint32_t most_records = 0;
    for (const CloudColumns& cloud : clouds) {
      bytes.push_back(bake::encodeCloud(cloud));
      specs.emplace_back();
      outs.emplace_back();
      for (const CloudColumn& column : cloud.columns) {
        specs.back().push_back({static_cast<uint8_t>(column.components),
                                column.is_unsigned ? runtime::ColumnKind::kUnsigned : runtime::ColumnKind::kSigned});
        values.emplace_back(column.values.size());
        outs.back().push_back(values.back().data());
      }
      value_count += valuesIn(cloud);
      most_records = std::max(most_records, cloud.records);
    }
    for (size_t i = 0; i < clouds.size(); ++i) {
      jobs.push_back({bytes[i].data(), bytes[i].size(), clouds[i].records, specs[i].data(),
                      static_cast<uint32_t>(specs[i].size()), outs[i].data()});
    }
    scratch_memory.resize(runtime::decodeScratchSize(most_records) / 8 + 1);
  }

  size_t byteCount() const {
    size_t count = 0;
    for (const auto& cloud : bytes) count += cloud.size();
    return count;
  }

  bool decodeWithLithe() {
    const runtime::DecodeScratch scratch = {scratch_memory.data(), scratch_memory.size() * 8};
    return runtime::decodeClouds(jobs.data(), static_cast<uint32_t>(jobs.size()), scratch, nullptr) ==
           runtime::CloudResult::kOk;
  }

  bool decodeWithDraco() {
    for (const auto& cloud : bytes) {
      draco::DecoderBuffer buffer;
      buffer.Init(reinterpret_cast<const char*>(cloud.data()), cloud.size());
      draco::Decoder decoder;
      auto decoded = decoder.DecodePointCloudFromBuffer(&buffer);
      if (!decoded.ok()) return false;
      benchmark::DoNotOptimize(decoded.value()->attribute(0)->buffer()->data());
    }
    return true;
  }
};

enum Reader { kLithe, kDraco };
enum Layout { kOneCloud, kCloudPerColumn };

void decodeSplits(benchmark::State& state, Reader reader, Layout layout) {
  const uint32_t records = static_cast<uint32_t>(state.range(0));
  const CloudColumns cloud = splitColumns(records);
  Prepared prepared(layout == kOneCloud ? std::vector<CloudColumns>{cloud} : oneCloudEach(cloud));
  for (auto _ : state) {
    if (!(reader == kLithe ? prepared.decodeWithLithe() : prepared.decodeWithDraco())) std::abort();
    benchmark::ClobberMemory();
  }
  const double rounds = static_cast<double>(state.iterations());
  state.counters["values/s"] =
      benchmark::Counter(rounds * static_cast<double>(prepared.value_count), benchmark::Counter::kIsRate);
  state.counters["records/s"] = benchmark::Counter(rounds * records, benchmark::Counter::kIsRate);
  state.counters["bytes"] = static_cast<double>(prepared.byteCount());
}

#define LITHE_RECORDS Arg(256)->Arg(1024)->Arg(2048)->Arg(4096)
BENCHMARK_CAPTURE(decodeSplits, one_cloud_lithe, kLithe, kOneCloud)->LITHE_RECORDS;
BENCHMARK_CAPTURE(decodeSplits, one_cloud_draco, kDraco, kOneCloud)->LITHE_RECORDS;
BENCHMARK_CAPTURE(decodeSplits, cloud_per_column_lithe, kLithe, kCloudPerColumn)->LITHE_RECORDS;
BENCHMARK_CAPTURE(decodeSplits, cloud_per_column_draco, kDraco, kCloudPerColumn)->LITHE_RECORDS;

}  // namespace
}  // namespace lithe

BENCHMARK_MAIN();
