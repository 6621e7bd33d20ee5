// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// From a file's bytes to what the GPU draws: time and memory of the finest level, one thread, beside libdraco.
//
//     bench_decode [NAME|FILE.glb ...]
//
// Without names: the built-in characters and the shared ones. lithe opens the file, takes every page and writes the
// default vertices and 32-bit indices; libdraco decodes the finest level alone (draco_reference.h) into its own arrays
// and writes no buffer. Vertices are those of the finest level alone, for both. Rivals take turns in one run; medians.
#include <cmath>
#include <cstdio>

#include "bench_character.h"
#include "draco_reference.h"
#include "malloc_allocator.h"
#include "page_clouds.h"
#include "timing.h"

namespace lithe::bench {
namespace {

struct Memory {
  uint64_t buffers = 0;  ///< finished vertices and indices
  uint64_t peak = 0;     ///< of what lithe allocated while it loaded
  uint64_t kept = 0;     ///< of it, when all is loaded
};

struct Decoding {
  std::string name;
  uint32_t vertices = 0, levels_vertices = 0;
  double lithe = 0, supply = 0, write = 0, draco = 0;  ///< seconds
  uint64_t clouds = 0, records = 0, values = 0;
  double lithe_records = 0, draco_records = 0;  ///< seconds for all records
  Memory memory;
};

void require(bool ok, const char* what) {
  if (!ok) throw bake::Error(std::string(what) + " fails");
}

AssetHandle load(const Character& character, const lithe_allocator* allocator = test::mallocAllocator()) {
  AssetHandle asset = openAsset(character.bytes, allocator);
  lithe_asset_info info;
  lithe_asset_describe(asset.get(), &info);
  require(lithe_asset_reserve(asset.get(), info.level_count - 1) == LITHE_OK, "making room for the finest level");
  supplyAll(*asset, character.bytes);
  return asset;
}

void timeWhole(const Character& character, const lithe_asset& loaded, Decoding& decoding) {
  const DracoReference reference = encodeReference(loaded);
  LevelBuffers buffers(loaded, lithe_vertex_layout_default(&loaded));
  buffers.write(loaded);
  decoding.vertices = usedVertices(buffers);
  decoding.levels_vertices = static_cast<uint32_t>(buffers.vertices.size() / buffers.layout.stride);
  decoding.memory.buffers = buffers.vertices.size() + buffers.indices.size() * sizeof(uint32_t);
  const std::vector<double> seconds = medianSeconds({
      [&] { buffers.write(*load(character)); },
      [&] { require(decodeReference(reference) > 0, "decoding the reference"); },
      [&] { load(character); },
      [&] { buffers.write(loaded); },
  });
  decoding.lithe = seconds[0];
  decoding.draco = seconds[1];
  decoding.supply = seconds[2];
  decoding.write = seconds[3];
}

void timeRecords(const Character& character, const lithe_asset& loaded, Decoding& decoding) {
  const std::vector<std::unique_ptr<CloudSet>> pages = pageClouds(loaded, character.bytes);
  for (const auto& page : pages) {
    decoding.clouds += page->cloudCount();
    decoding.records += page->recordCount();
    decoding.values += page->valueCount();
  }
  const std::vector<double> seconds = medianSeconds({
      [&] {
        for (const auto& page : pages) require(page->decodeWithLithe(), "decoding a page's clouds");
      },
      [&] {
        for (const auto& page : pages) require(page->decodeWithDraco(), "decoding a page's clouds with libdraco");
      },
  });
  decoding.lithe_records = seconds[0];
  decoding.draco_records = seconds[1];
}

void countMemory(const Character& character, Memory& memory) {
  test::FailingAllocator counter;
  const lithe_allocator allocator = counter.get();
  const AssetHandle asset = load(character, &allocator);
  memory.peak = counter.peak;
  memory.kept = counter.bytes;
}

Decoding measure(const std::string& name_or_path) {
  const Character character = bakeCharacter(name_or_path);
  const AssetHandle loaded = load(character);
  Decoding decoding;
  decoding.name = character.name;
  timeWhole(character, *loaded, decoding);
  timeRecords(character, *loaded, decoding);
  countMemory(character, decoding.memory);
  return decoding;
}

template <typename Value>
double geometricMean(const std::vector<Decoding>& all, const Value& value) {
  double sum = 0;
  for (const Decoding& decoding : all) sum += std::log(value(decoding));
  return std::exp(sum / static_cast<double>(all.size()));
}

// ---- Markdown
// --------------------------------------------------------------------------------------------------------

void printTimes(const std::vector<Decoding>& all) {
  std::printf(
      "Bytes to GPU-ready buffers of the finest level, one thread:\n\n"
      "| character | vertices | of all levels | lithe ms | of it supply | of it write | lithe Mvertices/s | libdraco "
      "ms "
      "| libdraco Mvertices/s | lithe / libdraco |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Decoding& d : all)
    std::printf("| %s | %u | %u | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |\n", d.name.c_str(), d.vertices,
                d.levels_vertices, 1e3 * d.lithe, 1e3 * d.supply, 1e3 * d.write, d.vertices / d.lithe / 1e6,
                1e3 * d.draco, d.vertices / d.draco / 1e6, d.draco / d.lithe);
  std::printf("| **geometric mean** | | | | | | **%.2f** | | **%.2f** | **%.2f** |\n",
              geometricMean(all, [](const Decoding& d) { return d.vertices / d.lithe / 1e6; }),
              geometricMean(all, [](const Decoding& d) { return d.vertices / d.draco / 1e6; }),
              geometricMean(all, [](const Decoding& d) { return d.draco / d.lithe; }));
}

void printRecords(const std::vector<Decoding>& all) {
  std::printf(
      "\nThe pages' clouds alone, by the runtime's reader and by libdraco:\n\n"
      "| character | clouds | records | values | lithe ms | libdraco ms | lithe Mrecords/s | libdraco Mrecords/s | "
      "lithe / libdraco |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const Decoding& d : all)
    std::printf("| %s | %llu | %llu | %llu | %.2f | %.2f | %.1f | %.1f | %.2f |\n", d.name.c_str(),
                static_cast<unsigned long long>(d.clouds), static_cast<unsigned long long>(d.records),
                static_cast<unsigned long long>(d.values), 1e3 * d.lithe_records, 1e3 * d.draco_records,
                static_cast<double>(d.records) / d.lithe_records / 1e6,
                static_cast<double>(d.records) / d.draco_records / 1e6, d.draco_records / d.lithe_records);
  std::printf("| **geometric mean** | | | | | | | | **%.2f** |\n",
              geometricMean(all, [](const Decoding& d) { return d.draco_records / d.lithe_records; }));
}

void printMemory(const std::vector<Decoding>& all) {
  const auto mib = [](uint64_t bytes) { return static_cast<double>(bytes) / (1024 * 1024); };
  const auto share = [](const Decoding& d) {
    return static_cast<double>(d.memory.peak) / static_cast<double>(d.memory.buffers);
  };
  std::printf(
      "\nMemory: what lithe allocates while it loads, beside the finished buffers (which are the host's):\n\n"
      "| character | buffers MiB | peak while loading MiB | kept MiB | peak / buffers |\n|---|---:|---:|---:|---:|\n");
  for (const Decoding& d : all)
    std::printf("| %s | %.2f | %.2f | %.2f | %.2f |\n", d.name.c_str(), mib(d.memory.buffers), mib(d.memory.peak),
                mib(d.memory.kept), share(d));
  std::printf("| **geometric mean** | | | | **%.2f** |\n", geometricMean(all, share));
}

void run(const std::vector<std::string>& names, bool) {
  std::vector<Decoding> all;
  for (const std::string& name : names) all.push_back(measure(name));
  printTimes(all);
  printRecords(all);
  printMemory(all);
}

}  // namespace
}  // namespace lithe::bench

int main(int argc, char** argv) {
  return lithe::bench::runOverCharacters(argc, argv, "bench_decode [NAME|FILE.glb ...]", lithe::bench::run);
}
