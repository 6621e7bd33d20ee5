// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "geometry.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "error.h"
#include "lithe/runtime.hpp"

namespace sample {
namespace {

uint64_t totalVertices(std::span<const Character> characters) {
  uint64_t count = 0;
  for (const Character& character : characters) count += character.info.vertex_count;
  return count;
}

uint64_t totalIndices(std::span<const Character> characters) {
  uint64_t count = 0;
  for (const Character& character : characters) {
    for (const lithe_level& level : character.levels) count += level.index_count;
  }
  return count;
}

lithe_attribute attribute(lithe_format format, size_t offset) {
  return {static_cast<uint16_t>(format), static_cast<uint16_t>(offset)};
}

/// SkinVertex in lithe's words.
lithe_vertex_layout layoutFor(const Character& character) {
  lithe_vertex_layout layout{};
  layout.struct_size = sizeof layout;
  layout.stride = sizeof(SkinVertex);
  layout.influences = kMaxInfluences;
  layout.position = attribute(LITHE_FORMAT_F32, offsetof(SkinVertex, position));
  if (character.info.has_normals) layout.normal = attribute(LITHE_FORMAT_SNORM16, offsetof(SkinVertex, normal));
  if (character.info.uv_sets > 0) layout.uv[0] = attribute(LITHE_FORMAT_F16, offsetof(SkinVertex, uv));
  layout.joints = attribute(LITHE_FORMAT_U16, offsetof(SkinVertex, joints));
  layout.weights = attribute(LITHE_FORMAT_UNORM8, offsetof(SkinVertex, weights));
  return layout;
}

void floatAttribute(GLuint location, GLint count, GLenum type, GLboolean normalized, size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, count, type, normalized, sizeof(SkinVertex), reinterpret_cast<const void*>(offset));
}

void integerAttribute(GLuint location, size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribIPointer(location, 4, GL_UNSIGNED_SHORT, sizeof(SkinVertex), reinterpret_cast<const void*>(offset));
}

/// The locations that the character shader names.
void describeVertices() {
  floatAttribute(0, 3, GL_FLOAT, GL_FALSE, offsetof(SkinVertex, position));
  floatAttribute(1, 2, GL_SHORT, GL_TRUE, offsetof(SkinVertex, normal));
  integerAttribute(2, offsetof(SkinVertex, joints));
  integerAttribute(3, offsetof(SkinVertex, joints) + 4 * sizeof(uint16_t));
  floatAttribute(4, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(SkinVertex, weights));
  floatAttribute(5, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(SkinVertex, weights) + 4);
  floatAttribute(6, 2, GL_HALF_FLOAT, GL_FALSE, offsetof(SkinVertex, uv));
}

}  // namespace

Geometry::Geometry(std::span<const Character> characters)
    : vertices_(totalVertices(characters) * sizeof(SkinVertex)), indices_(totalIndices(characters) * sizeof(uint32_t)) {
  uint32_t first_vertex = 0, first_index = 0;
  for (const Character& character : characters) {
    const lithe_asset_info& info = character.info;
    ranges_.emplace_back(size_t{info.level_count} * info.part_count);
    std::vector<uint32_t>& level_first_index = level_first_index_.emplace_back();
    for (const lithe_level& level : character.levels) {
      level_first_index.push_back(first_index);
      first_index += level.index_count;
    }
    placements_.push_back({static_cast<int32_t>(first_vertex), info.part_count, 0, ranges_.back().data()});
    first_vertex += info.vertex_count;
  }
  glGenVertexArrays(1, &vertex_array_);
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  describeVertices();
}

Geometry::~Geometry() { glDeleteVertexArrays(1, &vertex_array_); }

void Geometry::bind() const { glBindVertexArray(vertex_array_); }

void Geometry::upload(std::span<const Character> characters) {
  for (size_t i = 0; i < characters.size(); ++i) {
    const uint32_t resident = lithe_asset_resident_level(characters[i].asset.get());
    if (resident == LITHE_NO_LEVEL) continue;
    while (placements_[i].level_count <= resident) uploadLevel(characters[i], i, placements_[i].level_count++);
  }
}

void Geometry::uploadLevel(const Character& character, size_t index, uint32_t level) {
  const uint32_t already = level == 0 ? 0 : character.levels[level - 1].vertex_count;
  uploadVertices(character, index, already, character.levels[level].vertex_count);
  uploadIndices(character, index, level);
}

void Geometry::uploadVertices(const Character& character, size_t index, uint32_t begin, uint32_t end) {
  if (begin == end) return;
  const lithe_vertex_layout layout = layoutFor(character);
  const size_t offset = (placements_[index].vertex_offset + size_t{begin}) * sizeof(SkinVertex);
  const size_t size = size_t{end - begin} * sizeof(SkinVertex);
  void* memory = vertices_.mapUnread(offset, size);
  const lithe_result result =
      lithe_asset_write_vertices(character.asset.get(), &layout, begin, end - begin, memory, size);
  vertices_.unmap();
  check(result, character.name + ": vertices");
  bytes_uploaded_ += size;
}

void Geometry::orderForVertexCache(const Character& character, size_t level, std::span<const lithe_range> ranges,
                                   std::vector<uint32_t>& indices) {
  const uint32_t vertex_count = character.levels[level].vertex_count;
  order_scratch_.resize(
      std::max(order_scratch_.size(), lithe::orderScratch(static_cast<uint32_t>(indices.size()), vertex_count)));
  const lithe::Result result =
      lithe::orderIndices(lithe::Span<uint32_t>(indices), ranges, vertex_count, order_scratch_);
  check(static_cast<lithe_result>(result), character.name + ": ordering indices");
}

void Geometry::uploadIndices(const Character& character, size_t index, uint32_t level) {
  const uint32_t first = level_first_index_[index][level];
  const size_t size = size_t{character.levels[level].index_count} * sizeof(uint32_t);
  lithe_range* ranges = &ranges_[index][size_t{level} * character.info.part_count];
  std::vector<uint32_t> indices(character.levels[level].index_count);
  const lithe_result result =
      lithe_asset_write_indices(character.asset.get(), level, LITHE_INDEX_U32, indices.data(), size, ranges);
  check(result, character.name + ": indices");
  orderForVertexCache(character, level, {ranges, character.info.part_count}, indices);
  std::memcpy(indices_.mapUnread(first * sizeof(uint32_t), size), indices.data(), size);
  indices_.unmap();
  for (uint32_t part = 0; part < character.info.part_count; ++part) ranges[part].first_index += first;
  bytes_uploaded_ += size;
}

}  // namespace sample
