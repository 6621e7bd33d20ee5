// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The runtime in C++17: ownership, ranges and an allocator over lithe/runtime.h, and nothing of its own. Neither
/// exceptions nor run-time type information are needed. What functions do, cost and promise is said in lithe/runtime.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include "lithe/runtime.h"

namespace lithe {

/// lithe_result, typed. The values are the same.
enum class Result : int {
  kOk = LITHE_OK,
  kPending = LITHE_PENDING,
  kComplete = LITHE_COMPLETE,
  kTruncated = LITHE_ERROR_TRUNCATED,
  kNotThisFormat = LITHE_ERROR_NOT_THIS_FORMAT,
  kVersionTooNew = LITHE_ERROR_VERSION_TOO_NEW,
  kCorrupt = LITHE_ERROR_CORRUPT,
  kLimit = LITHE_ERROR_LIMIT,
  kInvalidArgument = LITHE_ERROR_INVALID_ARGUMENT,
  kBufferTooSmall = LITHE_ERROR_BUFFER_TOO_SMALL,
  kNotResident = LITHE_ERROR_NOT_RESIDENT,
  kOutOfMemory = LITHE_ERROR_OUT_OF_MEMORY,
};

constexpr bool isError(Result result) { return static_cast<int>(result) >= LITHE_ERROR_TRUNCATED; }
inline const char* nameOf(Result result) { return lithe_result_name(static_cast<lithe_result>(result)); }

/// Borrowed elements side by side. Not checked: the index must be below size.
template <typename T>
struct Span {
  T* data = nullptr;
  std::size_t size = 0;

  constexpr Span() = default;
  constexpr Span(T* first, std::size_t count) : data(first), size(count) {}
  template <std::size_t kCount>
  constexpr Span(T (&array)[kCount]) : data(array), size(kCount) {}
  /// From anything with data() and size(), such as std::vector, std::array and std::span.
  template <typename Range,
            typename = std::enable_if_t<std::is_convertible_v<decltype(std::declval<Range&>().data()), T*>>>
  constexpr Span(Range&& range) : data(range.data()), size(range.size()) {}

  constexpr T& operator[](std::size_t index) const { return data[index]; }
  constexpr T* begin() const { return data; }
  constexpr T* end() const { return data + size; }
};

/// The C library's memory, with every alignment that lithe may ask for.
inline lithe_allocator mallocAllocator() {
  lithe_allocator allocator = {};
  allocator.alloc = [](void*, std::size_t size, std::size_t alignment) -> void* {
    // free is not told the alignment, so every block carries its own address in front.
    if (alignment < sizeof(void*)) alignment = sizeof(void*);
    if (size > SIZE_MAX - alignment - sizeof(void*)) return nullptr;
    void* block = std::malloc(size + alignment + sizeof(void*));
    if (!block) return nullptr;
    const std::uintptr_t after = reinterpret_cast<std::uintptr_t>(block) + sizeof(void*);
    void** memory = reinterpret_cast<void**>((after + alignment - 1) & ~(std::uintptr_t{alignment} - 1));
    memory[-1] = block;
    return memory;
  };
  allocator.free = [](void*, void* memory, std::size_t) { std::free(static_cast<void**>(memory)[-1]); };
  return allocator;
}

/// Owns an opened asset. Movable; a moved-from or default one is empty and only good for assignment and destruction.
class Asset {
 public:
  Asset() = default;
  explicit Asset(lithe_asset* asset) : asset_(asset) {}  ///< takes it over
  ~Asset() { lithe_asset_close(asset_); }
  Asset(Asset&& other) noexcept : asset_(std::exchange(other.asset_, nullptr)) {}
  Asset& operator=(Asset&& other) noexcept {
    std::swap(asset_, other.asset_);
    return *this;
  }

  /// Opens an asset from the first bytes of its file, as many as peek() says.
  /// asset   receives the opened one; left as it was on an error
  [[nodiscard]] static Result open(Span<const std::uint8_t> head, Asset* asset, lithe_diagnosis* diagnosis = nullptr,
                                   const lithe_allocator& allocator = mallocAllocator()) {
    lithe_asset* opened = nullptr;
    const lithe_result result = lithe_asset_open(&allocator, head.data, head.size, diagnosis, &opened);
    if (result == LITHE_OK) *asset = Asset(opened);
    return static_cast<Result>(result);
  }

  [[nodiscard]] static Result peek(Span<const std::uint8_t> start, std::uint64_t* head_bytes) {
    return static_cast<Result>(lithe_peek(start.data, start.size, head_bytes));
  }

  explicit operator bool() const { return asset_ != nullptr; }
  lithe_asset* get() const { return asset_; }
  lithe_asset* release() { return std::exchange(asset_, nullptr); }

  // ---- What it says of itself; indices must be in range ------------------------------------------------------------

  lithe_asset_info info() const {
    lithe_asset_info info = {};
    lithe_asset_describe(asset_, &info);
    return info;
  }
  lithe_node node(std::uint32_t index) const { return read(lithe_asset_node, index); }
  lithe_joint joint(std::uint32_t index) const { return read(lithe_asset_joint, index); }
  lithe_part part(std::uint32_t index) const { return read(lithe_asset_part, index); }
  lithe_level level(std::uint32_t index) const { return read(lithe_asset_level, index); }
  lithe_page page(std::uint32_t index) const { return read(lithe_asset_page, index); }
  lithe_level_extent levelExtent(std::uint32_t level) const { return read(lithe_asset_level_extent, level); }

  // ---- Streaming ---------------------------------------------------------------------------------------------------

  [[nodiscard]] Result nextRequest(std::uint32_t level, lithe_request* request) const {
    return static_cast<Result>(lithe_asset_next_request(asset_, level, request));
  }
  [[nodiscard]] Result supply(std::uint32_t page, Span<const std::uint8_t> bytes,
                              lithe_diagnosis* diagnosis = nullptr) {
    return static_cast<Result>(lithe_asset_supply(asset_, page, bytes.data, bytes.size, diagnosis));
  }
  [[nodiscard]] Result reserve(std::uint32_t level) { return static_cast<Result>(lithe_asset_reserve(asset_, level)); }
  [[nodiscard]] Result evict(std::uint32_t level) { return static_cast<Result>(lithe_asset_evict(asset_, level)); }
  std::uint64_t memory(std::uint32_t level) const { return lithe_asset_memory(asset_, level); }
  std::uint32_t residentLevel() const { return lithe_asset_resident_level(asset_); }

  // ---- Buffers -----------------------------------------------------------------------------------------------------

  lithe_vertex_layout defaultLayout() const { return lithe_vertex_layout_default(asset_); }
  [[nodiscard]] Result writeVertices(const lithe_vertex_layout& layout, std::uint32_t first, std::uint32_t count,
                                     Span<std::uint8_t> destination) const {
    return static_cast<Result>(
        lithe_asset_write_vertices(asset_, &layout, first, count, destination.data, destination.size));
  }
  /// ranges: empty, or part_count of them.
  [[nodiscard]] Result writeIndices(std::uint32_t level, Span<std::uint16_t> destination,
                                    Span<lithe_range> ranges = {}) const {
    return writeIndices(level, LITHE_INDEX_U16, destination, ranges);
  }
  [[nodiscard]] Result writeIndices(std::uint32_t level, Span<std::uint32_t> destination,
                                    Span<lithe_range> ranges = {}) const {
    return writeIndices(level, LITHE_INDEX_U32, destination, ranges);
  }
  [[nodiscard]] Result writeMorphSources(std::uint32_t level, Span<std::uint32_t> destination) const {
    return static_cast<Result>(lithe_asset_write_morph_sources(asset_, level, destination.data, destination.size));
  }

  // ---- Hierarchy and bounds ----------------------------------------------------------------------------------------

  lithe_hierarchy hierarchy() const {
    lithe_hierarchy hierarchy = {};
    lithe_asset_hierarchy(asset_, &hierarchy);
    return hierarchy;
  }
  /// palette: joint_count matrices of 12 floats.
  void posedBox(const float* palette, float (&box)[6]) const { lithe_asset_posed_box(asset_, palette, box); }

 private:
  template <typename Record>
  Record read(lithe_result (*getter)(const lithe_asset*, std::uint32_t, Record*), std::uint32_t index) const {
    Record record = {};
    (void)getter(asset_, index, &record);
    return record;
  }

  template <typename Index>
  Result writeIndices(std::uint32_t level, lithe_index_type type, Span<Index> destination,
                      Span<lithe_range> ranges) const {
    const std::uint32_t part_count = ranges.data ? info().part_count : 0;
    if (ranges.size < part_count) return Result::kBufferTooSmall;
    return static_cast<Result>(lithe_asset_write_indices(asset_, level, type, destination.data,
                                                         destination.size * sizeof(Index), ranges.data));
  }

  lithe_asset* asset_ = nullptr;
};

/// Assets and the instances of them. Where the instances begin larger structs of the host, fill a lithe_crowd.
inline lithe_crowd crowdOf(Span<const lithe_asset* const> assets, Span<lithe_instance> instances) {
  return {assets.data, instances.data, 0, static_cast<std::uint32_t>(assets.size),
          static_cast<std::uint32_t>(instances.size)};
}

/// lithe_select. wanted_levels: empty, or one per asset.
[[nodiscard]] inline Result select(const lithe_crowd& crowd, Span<const lithe_view> views,
                                   Span<std::uint32_t> wanted_levels = {}, lithe_select_stats* stats = nullptr) {
  if (wanted_levels.data && wanted_levels.size < crowd.asset_count) return Result::kBufferTooSmall;
  return static_cast<Result>(
      lithe_select(&crowd, views.data, static_cast<std::uint32_t>(views.size), wanted_levels.data, stats));
}

inline std::size_t budgetScratch(std::uint32_t instance_count) {
  return static_cast<std::size_t>(lithe_budget_scratch(instance_count));
}

/// lithe_select_within. scratch: budgetScratch() bytes, aligned to 8.
[[nodiscard]] inline Result selectWithin(const lithe_crowd& crowd, Span<const lithe_view> views,
                                         std::uint64_t triangles, Span<std::uint8_t> scratch,
                                         Span<std::uint32_t> wanted_levels = {}, lithe_select_stats* stats = nullptr,
                                         float* factor = nullptr) {
  if (wanted_levels.data && wanted_levels.size < crowd.asset_count) return Result::kBufferTooSmall;
  return static_cast<Result>(lithe_select_within(&crowd, views.data, static_cast<std::uint32_t>(views.size), triangles,
                                                 wanted_levels.data, stats, scratch.data, scratch.size, factor));
}

/// lithe_morph_factors. morphs: one per instance.
[[nodiscard]] inline Result morphFactors(const lithe_crowd& crowd, Span<const lithe_view> views, float factor,
                                         float width, Span<float> morphs) {
  if (morphs.size < crowd.instance_count) return Result::kBufferTooSmall;
  return static_cast<Result>(
      lithe_morph_factors(&crowd, views.data, static_cast<std::uint32_t>(views.size), factor, width, morphs.data));
}

/// Where lithe_build_draws puts what it finds; sizes are checked. keys may be empty.
struct DrawBuffers {
  Span<std::uint32_t> instance_order;
  Span<lithe_draw> draws;
  Span<lithe_draw_key> keys;
  Span<std::uint32_t> counters;
};

inline std::size_t orderScratch(std::uint32_t index_count, std::uint32_t vertex_count) {
  return static_cast<std::size_t>(lithe_order_scratch(index_count, vertex_count));
}

/// Index: uint16_t or uint32_t. scratch: orderScratch() bytes, aligned to 4.
template <typename Index>
[[nodiscard]] Result orderIndices(Span<Index> indices, Span<const lithe_range> ranges, std::uint32_t vertex_count,
                                  Span<std::uint8_t> scratch) {
  constexpr lithe_index_type kType = sizeof(Index) == 2 ? LITHE_INDEX_U16 : LITHE_INDEX_U32;
  static_assert(sizeof(Index) == 2 || sizeof(Index) == 4, "indices have 16 or 32 bits");
  return static_cast<Result>(lithe_order_indices(indices.data, kType, static_cast<std::uint32_t>(indices.size),
                                                 ranges.data, static_cast<std::uint32_t>(ranges.size), vertex_count,
                                                 scratch.data, scratch.size));
}

/// lithe_build_draws. view_mask: which views' instances are drawn.
[[nodiscard]] inline Result buildDraws(const lithe_crowd& crowd, Span<const lithe_placement> placements,
                                       std::uint32_t view_mask, const DrawBuffers& buffers, std::uint32_t* draw_count) {
  const std::uint32_t bound = lithe_draws_bound(placements.data, static_cast<std::uint32_t>(placements.size));
  if (placements.size < crowd.asset_count) return Result::kInvalidArgument;
  if (buffers.instance_order.size < crowd.instance_count || buffers.draws.size < bound ||
      buffers.counters.size < bound || (buffers.keys.data && buffers.keys.size < bound))
    return Result::kBufferTooSmall;
  return static_cast<Result>(lithe_build_draws(&crowd, placements.data, view_mask, buffers.instance_order.data,
                                               buffers.draws.data, buffers.keys.data, draw_count,
                                               buffers.counters.data));
}

}  // namespace lithe
