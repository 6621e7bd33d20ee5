// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "draw_list.h"

#include "error.h"
#include "shaders.h"

namespace sample {
namespace {

/// The levels come and go, the number of parts and levels does not: the bound holds for all time.
uint32_t drawBound(std::span<const Character> characters, const Geometry& geometry) {
  std::vector<lithe_placement> complete = geometry.placements();
  for (size_t i = 0; i < complete.size(); ++i) complete[i].level_count = characters[i].info.level_count;
  return lithe_draws_bound(complete.data(), static_cast<uint32_t>(complete.size()));
}

}  // namespace

DrawList::DrawList(std::span<const Character> characters, const Geometry& geometry, uint32_t capacity)
    : geometry_(&geometry),
      order_(capacity),
      counters_(drawBound(characters, geometry)),
      budget_scratch_(lithe_budget_scratch(capacity) / sizeof(uint64_t) + 1),
      draws_(counters_.size()),
      keys_(counters_.size()),
      record_buffer_(capacity * sizeof(InstanceRecord)),
      order_buffer_(capacity * sizeof(uint32_t)),
      draw_buffer_(draws_.size() * sizeof(lithe_draw)) {
  for (const Character& character : characters) assets_.push_back(character.asset.get());
  instances_.reserve(capacity);
  records_.reserve(capacity);
}

void DrawList::clear() {
  instances_.clear();
  records_.clear();
  draw_count_ = 0;
}

void DrawList::push(const lithe_instance& instance, const InstanceRecord& record) {
  if (instances_.size() == order_.size()) throw Error("a draw list is full");
  instances_.push_back(instance);
  records_.push_back(record);
}

void DrawList::select(const lithe_view& view, uint32_t* wanted, lithe_select_stats* stats) {
  const lithe_crowd crowd = crowdOfAll();
  check(lithe_select(&crowd, &view, 1, wanted, stats), "lithe_select");
}

float DrawList::selectWithin(const lithe_view& view, uint64_t triangles, uint32_t* wanted, lithe_select_stats* stats) {
  const lithe_crowd crowd = crowdOfAll();
  float factor = 1;
  check(lithe_select_within(&crowd, &view, 1, triangles, wanted, stats, budget_scratch_.data(),
                            budget_scratch_.size() * sizeof(uint64_t), &factor),
        "lithe_select_within");
  return factor;
}

lithe_crowd DrawList::crowdOfAll() {
  return {assets_.data(), instances_.data(), 0, static_cast<uint32_t>(assets_.size()), size()};
}

void DrawList::build() {
  const lithe_crowd crowd = crowdOfAll();
  check(lithe_build_draws(&crowd, geometry_->placements().data(), ~0u, order_.data(), draws_.data(), keys_.data(),
                          &draw_count_, counters_.data()),
        "lithe_build_draws");
}

void DrawList::upload() {
  record_buffer_.write(std::span<const InstanceRecord>(records_));
  order_buffer_.write(std::span<const uint32_t>(order_));
  draw_buffer_.write(draws());
}

void DrawList::draw() const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kInstanceBinding, record_buffer_.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kOrderBinding, order_buffer_.id());
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, draw_buffer_.id());
  geometry_->bind();
  glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(draw_count_),
                              sizeof(lithe_draw));
}

}  // namespace sample
