// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// An opened asset and everything it draws, in containers that can be compared.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "lithe/runtime.h"
#include "malloc_allocator.h"

namespace lithe::test {

/// What every test needs of a vertex; further attributes are looked at as bytes, see AssetReader::vertexBytes().
struct SkinnedVertex {
  float position[3];
  uint16_t joints[8];
  float weights[8];
};

class AssetReader {
 public:
  /// @param bytes  a whole file; must outlive the reader
  explicit AssetReader(const std::vector<uint8_t>& bytes) : bytes_(bytes) {
    lithe_diagnosis diagnosis{};
    EXPECT_EQ(lithe_asset_open(mallocAllocator(), bytes.data(), bytes.size(), &diagnosis, &asset_), LITHE_OK)
        << "check " << diagnosis.check << " at " << diagnosis.offset;
    if (asset_) lithe_asset_describe(asset_, &info_);
  }
  ~AssetReader() { lithe_asset_close(asset_); }
  AssetReader(const AssetReader&) = delete;
  AssetReader& operator=(const AssetReader&) = delete;

  lithe_asset* get() const { return asset_; }
  const lithe_asset_info& info() const { return info_; }

  lithe_level level(uint32_t index) const {
    lithe_level level{};
    EXPECT_EQ(lithe_asset_level(asset_, index, &level), LITHE_OK);
    return level;
  }

  /// Supplies the next page on the way to the finest level; false when there is none.
  bool supplyNext() {
    lithe_request request;
    if (lithe_asset_next_request(asset_, info_.level_count - 1, &request) != LITHE_OK) return false;
    return supply(request);
  }

  void supplyThrough(uint32_t level) {
    lithe_request request;
    while (lithe_asset_next_request(asset_, level, &request) == LITHE_OK && supply(request)) {
    }
  }

  std::vector<SkinnedVertex> vertices(uint32_t count) const {
    lithe_vertex_layout layout{};
    layout.struct_size = sizeof(layout);
    layout.stride = sizeof(SkinnedVertex);
    layout.influences = 8;
    layout.position = {LITHE_FORMAT_F32, offsetof(SkinnedVertex, position)};
    layout.joints = {LITHE_FORMAT_U16, offsetof(SkinnedVertex, joints)};
    layout.weights = {LITHE_FORMAT_F32, offsetof(SkinnedVertex, weights)};
    std::vector<SkinnedVertex> result(count);
    EXPECT_EQ(lithe_asset_write_vertices(asset_, &layout, 0, count, result.data(), count * sizeof(SkinnedVertex)),
              LITHE_OK);
    return result;
  }

  /// All attributes of the first `count` vertices in the default layout.
  std::vector<uint8_t> vertexBytes(uint32_t count) const {
    const lithe_vertex_layout layout = lithe_vertex_layout_default(asset_);
    std::vector<uint8_t> result(size_t{count} * layout.stride, 0);
    EXPECT_EQ(lithe_asset_write_vertices(asset_, &layout, 0, count, result.data(), result.size()), LITHE_OK);
    return result;
  }

  std::vector<uint32_t> indices(uint32_t level_index, std::vector<lithe_range>* ranges = nullptr) const {
    std::vector<uint32_t> result(level(level_index).index_count);
    std::vector<lithe_range> unused(info_.part_count);
    if (ranges) ranges->resize(info_.part_count);
    EXPECT_EQ(lithe_asset_write_indices(asset_, level_index, LITHE_INDEX_U32, result.data(), 4 * result.size(),
                                        ranges ? ranges->data() : unused.data()),
              LITHE_OK);
    return result;
  }

  lithe_hierarchy hierarchy() const {
    lithe_hierarchy view{};
    lithe_asset_hierarchy(asset_, &view);
    return view;
  }

 private:
  bool supply(const lithe_request& request) {
    lithe_diagnosis diagnosis{};
    const lithe_result result =
        lithe_asset_supply(asset_, request.page, bytes_.data() + request.offset, request.size, &diagnosis);
    EXPECT_EQ(result, LITHE_OK) << "page " << request.page << " check " << diagnosis.check << " at "
                                << diagnosis.offset;
    return result == LITHE_OK;
  }

  const std::vector<uint8_t>& bytes_;
  lithe_asset* asset_ = nullptr;
  lithe_asset_info info_{};
};

/// The bytes of all levels' buffers: what a GPU would get.
struct DrawnLevel {
  std::vector<uint8_t> vertices;
  std::vector<uint32_t> indices;
  std::vector<uint32_t> morph_sources;  ///< none for level 0

  bool operator==(const DrawnLevel&) const = default;
};

inline DrawnLevel drawnLevel(const AssetReader& reader, uint32_t level) {
  DrawnLevel drawn{reader.vertexBytes(reader.level(level).vertex_count), reader.indices(level), {}};
  if (level == 0) return drawn;
  drawn.morph_sources.resize(reader.level(level).vertex_count);
  EXPECT_EQ(
      lithe_asset_write_morph_sources(reader.get(), level, drawn.morph_sources.data(), drawn.morph_sources.size()),
      LITHE_OK);
  return drawn;
}

inline std::vector<DrawnLevel> drawnLevels(const AssetReader& reader) {
  std::vector<DrawnLevel> levels;
  for (uint32_t level = 0; level < reader.info().level_count; ++level) levels.push_back(drawnLevel(reader, level));
  return levels;
}

}  // namespace lithe::test
