// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "memory.h"

#include <string.h>

namespace lithe::runtime {
namespace {

constexpr uint64_t kFaceBytes = 6 * sizeof(uint32_t);

uint64_t nodeBlock(uint64_t count, const RecordWidths& widths) {
  const uint64_t bytes = 4 * sizeof(uint32_t) + (3 + 2 * uint64_t{widths.influences}) * sizeof(uint16_t);
  return count ? count * bytes + sizeof(uint32_t) : 0;
}
uint64_t wedgeBlock(uint64_t count, const RecordWidths& widths) {
  return count * (2 * sizeof(uint32_t) + (1 + uint64_t{widths.attributes}) * sizeof(uint16_t));
}
uint64_t faceBlock(uint64_t count) { return count * kFaceBytes; }
uint64_t hiddenBlock(uint64_t count) { return count * sizeof(uint32_t); }

/// Hands out a new block in pieces, each filled with what the array that it replaces held.
struct Move {
  uint8_t* at;

  template <typename T>
  void array(T** pointer, size_t capacity, size_t count) {
    if (!at) {
      *pointer = nullptr;
      return;
    }
    T* piece = reinterpret_cast<T*>(at);
    if (count) memcpy(piece, *pointer, count * sizeof(T));
    *pointer = piece;
    at += capacity * sizeof(T);
  }
};

/// One block of arrays: its size now and then, and how its arrays move to another one.
template <typename MoveArrays>
bool replaceBlock(const lithe_allocator& allocator, void* old_block, uint64_t old_size, uint64_t new_size,
                  MoveArrays moveArrays) {
  void* block = new_size ? allocateBlock(allocator, new_size) : nullptr;
  if (new_size && !block) return false;
  moveArrays(Move{static_cast<uint8_t*>(block)});
  freeBlock(allocator, old_block, old_size);
  return true;
}

// The arrays of wider elements come first in every block, so each is aligned.

bool resizeNodes(const lithe_allocator& allocator, uint32_t capacity, const RecordWidths& widths, Decoded* d) {
  const bool done = replaceBlock(
      allocator, d->node_parent, nodeBlock(d->node_capacity, widths), nodeBlock(capacity, widths), [&](Move move) {
        const size_t count = d->node_count, firsts = count ? count + 1 : 0, skin = size_t{2} * widths.influences;
        move.array(&d->node_parent, capacity, count);
        move.array(&d->node_first_child, capacity, count);
        move.array(&d->node_first_wedge, size_t{capacity} + 1, firsts);
        move.array(&d->node_first_corner, capacity, count);
        move.array(&d->node_position, 3 * size_t{capacity}, 3 * count);
        move.array(&d->node_skin, skin * capacity, skin * count);
      });
  if (done) d->node_capacity = capacity;
  return done;
}

bool resizeWedges(const lithe_allocator& allocator, uint32_t capacity, const RecordWidths& widths, Decoded* d) {
  const bool done = replaceBlock(allocator, d->wedge_node, wedgeBlock(d->wedge_capacity, widths),
                                 wedgeBlock(capacity, widths), [&](Move move) {
                                   const size_t count = d->wedge_count, stride = widths.attributes;
                                   move.array(&d->wedge_node, capacity, count);
                                   move.array(&d->wedge_parent, capacity, count);
                                   move.array(&d->wedge_part, capacity, count);
                                   move.array(&d->wedge_attributes, stride * capacity, stride * count);
                                 });
  if (done) d->wedge_capacity = capacity;
  return done;
}

bool resizeFaces(const lithe_allocator& allocator, uint32_t capacity, Decoded* d) {
  const bool done =
      replaceBlock(allocator, d->face_wedges, faceBlock(d->face_capacity), faceBlock(capacity), [&](Move move) {
        move.array(&d->face_wedges, 3 * size_t{capacity}, 3 * size_t{d->face_count});
        move.array(&d->corner_next, 3 * size_t{capacity}, 3 * size_t{d->face_count});
      });
  if (done) d->face_capacity = capacity;
  return done;
}

bool resizeHidden(const lithe_allocator& allocator, uint32_t capacity, Decoded* d) {
  const bool done = replaceBlock(allocator, d->hidden_faces, hiddenBlock(d->hidden_capacity), hiddenBlock(capacity),
                                 [&](Move move) { move.array(&d->hidden_faces, capacity, d->hidden_count); });
  if (done) d->hidden_capacity = capacity;
  return done;
}

}  // namespace

uint64_t decodedBytes(const Counts& counts, const RecordWidths& widths) {
  return nodeBlock(counts.nodes, widths) + wedgeBlock(counts.wedges, widths) + faceBlock(counts.faces) +
         hiddenBlock(counts.hidden);
}

uint64_t largestBlock(const Counts& counts, const RecordWidths& widths) {
  const uint64_t blocks[] = {nodeBlock(counts.nodes, widths), wedgeBlock(counts.wedges, widths),
                             faceBlock(counts.faces), hiddenBlock(counts.hidden)};
  uint64_t largest = 0;
  for (const uint64_t block : blocks)
    if (block > largest) largest = block;
  return largest;
}

bool reserveDecoded(const lithe_allocator& allocator, const Counts& counts, const RecordWidths& widths, Decoded* d) {
  return (counts.nodes <= d->node_capacity || resizeNodes(allocator, counts.nodes, widths, d)) &&
         (counts.wedges <= d->wedge_capacity || resizeWedges(allocator, counts.wedges, widths, d)) &&
         (counts.faces <= d->face_capacity || resizeFaces(allocator, counts.faces, d)) &&
         (counts.hidden <= d->hidden_capacity || resizeHidden(allocator, counts.hidden, d));
}

void shrinkDecoded(const lithe_allocator& allocator, const Counts& counts, const RecordWidths& widths, Decoded* d) {
  if (counts.nodes < d->node_capacity) resizeNodes(allocator, counts.nodes, widths, d);
  if (counts.wedges < d->wedge_capacity) resizeWedges(allocator, counts.wedges, widths, d);
  if (counts.faces < d->face_capacity) resizeFaces(allocator, counts.faces, d);
  if (counts.hidden < d->hidden_capacity) resizeHidden(allocator, counts.hidden, d);
}

void freeDecoded(const lithe_allocator& allocator, const RecordWidths& widths, Decoded* d) {
  freeBlock(allocator, d->node_parent, nodeBlock(d->node_capacity, widths));
  freeBlock(allocator, d->wedge_node, wedgeBlock(d->wedge_capacity, widths));
  freeBlock(allocator, d->face_wedges, faceBlock(d->face_capacity));
  freeBlock(allocator, d->hidden_faces, hiddenBlock(d->hidden_capacity));
  *d = {};
}

}  // namespace lithe::runtime
