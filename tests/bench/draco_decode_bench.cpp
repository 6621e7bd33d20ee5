// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// The runtime's Draco reader against libdraco's, on the same clouds, one thread. Columns are shaped like a page's:
// flags, ranks, residuals. Run with --benchmark_repetitions=9 --benchmark_report_aggregates_only and compare medians.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "cloud_set.h"
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

/// The same columns as a page has them: each in a cloud of its own.
std::vector<CloudColumns> oneCloudEach(const CloudColumns& cloud) {
  std::vector<CloudColumns> clouds;
  for (const CloudColumn& column : cloud.columns) clouds.push_back({cloud.records, {column}, false});
  return clouds;
}

void addCloud(const CloudColumns& cloud, bench::CloudSet& clouds) {
  std::vector<runtime::ColumnSpec> columns;
  std::vector<uint8_t> components;
  for (const CloudColumn& column : cloud.columns) {
    components.push_back(static_cast<uint8_t>(column.components));
    columns.push_back(
        {components.back(), column.is_unsigned ? runtime::ColumnKind::kUnsigned : runtime::ColumnKind::kSigned});
  }
  const std::vector<uint8_t> bytes =
      bake::withoutBeginning(bake::encodeCloud(cloud), bake::cloudBeginning(cloud.records, components));
  clouds.add(bytes.data(), bytes.size(), cloud.records, columns);
}

enum Reader { kLithe, kDraco };
enum Layout { kOneCloud, kCloudPerColumn };

void decodeSplits(benchmark::State& state, Reader reader, Layout layout) {
  const uint32_t records = static_cast<uint32_t>(state.range(0));
  const CloudColumns cloud = splitColumns(records);
  bench::CloudSet clouds;
  for (const CloudColumns& one : layout == kOneCloud ? std::vector<CloudColumns>{cloud} : oneCloudEach(cloud))
    addCloud(one, clouds);
  for (auto _ : state) {
    if (!(reader == kLithe ? clouds.decodeWithLithe() : clouds.decodeWithDraco())) std::abort();
    benchmark::ClobberMemory();
  }
  const double rounds = static_cast<double>(state.iterations());
  state.counters["values/s"] =
      benchmark::Counter(rounds * static_cast<double>(clouds.valueCount()), benchmark::Counter::kIsRate);
  state.counters["records/s"] = benchmark::Counter(rounds * records, benchmark::Counter::kIsRate);
  state.counters["bytes"] = static_cast<double>(clouds.byteCount());
}

#define LITHE_RECORDS Arg(256)->Arg(1024)->Arg(2048)->Arg(4096)
BENCHMARK_CAPTURE(decodeSplits, one_cloud_lithe, kLithe, kOneCloud)->LITHE_RECORDS;
BENCHMARK_CAPTURE(decodeSplits, one_cloud_draco, kDraco, kOneCloud)->LITHE_RECORDS;
BENCHMARK_CAPTURE(decodeSplits, cloud_per_column_lithe, kLithe, kCloudPerColumn)->LITHE_RECORDS;
BENCHMARK_CAPTURE(decodeSplits, cloud_per_column_draco, kDraco, kCloudPerColumn)->LITHE_RECORDS;

}  // namespace
}  // namespace lithe

BENCHMARK_MAIN();
