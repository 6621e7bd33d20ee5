// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "page.h"

#include "lithe/format/file.h"
#include "page_base.h"
#include "split_decoder.h"

namespace lithe::runtime {
namespace {

using format::kNoIndex;

size_t aligned(size_t size) { return (size + 7) & ~size_t{7}; }

uint32_t largestStream(const PagePlan& plan) {
  return plan.values < kMaxCloudRecords ? (plan.values ? plan.values : 1) : kMaxCloudRecords;
}

/// Hands out the scratch in pieces.
struct ScratchCursor {
  uint8_t* at;

  template <typename T>
  T* take(size_t count) {
    T* piece = reinterpret_cast<T*>(at);
    at += aligned(count * sizeof(T));
    return piece;
  }
};

/// The faces that are not drawn, level by level: gaps between ascending ids.
bool readHidden(const PagePlan& plan, const PageStreams& streams, Decoded* decoded) {
  const uint8_t* at = streams.hidden;
  for (uint32_t l = 0; l < plan.ended_levels; ++l) {
    uint64_t face = 0;
    for (uint32_t i = 0; i < plan.ends[l].hidden_count; ++i) {
      uint32_t gap = 0;
      if (!readVarint(&at, streams.hidden_end, &gap) || (i > 0 && gap == 0)) return false;
      face += gap;
      if (face >= plan.ends[l].face_count) return false;
      decoded->hidden_faces[decoded->hidden_count++] = static_cast<uint32_t>(face);
    }
    decoded->hidden_end[plan.level + l] = decoded->hidden_count;
  }
  return at == streams.hidden_end;
}

uint32_t decodeSplits(const PageFormat& format, const PagePlan& plan, PageStreams* streams, ScratchCursor* scratch,
                      Decoded* decoded, uint32_t* cursor) {
  const size_t fan = plan.max_fan;
  FanScratch fan_scratch;
  fan_scratch.capacity = plan.max_fan;
  fan_scratch.corner = scratch->take<uint32_t>(fan);
  fan_scratch.next = scratch->take<uint32_t>(fan);
  fan_scratch.previous = scratch->take<uint32_t>(fan);
  fan_scratch.wedge = scratch->take<uint32_t>(fan);
  for (uint32_t step = 0; step < 2; ++step) {
    fan_scratch.other_wedge[step] = scratch->take<uint32_t>(fan);
    fan_scratch.other_at[step] = scratch->take<format::Int3>(fan);
  }
  fan_scratch.classes = scratch->take<WedgeClass>(fan);
  fan_scratch.sorted = scratch->take<uint32_t>(2 * fan);
  fan_scratch.at_b = scratch->take<uint8_t>(fan);
  SplitDecoder decoder(format, plan, streams, fan_scratch, decoded);
  return decoder.run(cursor);
}

uint32_t applyPage(const PageFormat& format, const PagePlan& plan, PageStreams* streams, ScratchCursor* scratch,
                   Decoded* decoded, uint32_t* cursor) {
  uint32_t check;
  if (plan.level == 0) {
    check = decodeBase(format, plan, streams, decoded);
    if (check == 0) {
      decoded->node_count = plan.node_count;
      decoded->wedge_count = plan.wedge_count;
      decoded->face_count = plan.face_count;
    }
  } else {
    check = decodeSplits(format, plan, streams, scratch, decoded, cursor);
  }
  if (check) return check;
  if (!streamsExhausted(*streams)) return kCheckStream;
  if (decoded->node_count != plan.node_count || decoded->wedge_count != plan.wedge_count ||
      decoded->face_count != plan.face_count)
    return kCheckCounts;
  return failUnless(readHidden(plan, *streams, decoded), kCheckHidden);
}

}  // namespace

size_t pageScratchBytes(const PagePlan& plan) {
  const size_t fan = plan.max_fan;
  return aligned(size_t{plan.values} * sizeof(int32_t)) + 6 * aligned(fan * sizeof(uint32_t)) +
         2 * aligned(fan * sizeof(format::Int3)) + aligned(fan * sizeof(WedgeClass)) +
         aligned(2 * fan * sizeof(uint32_t)) + aligned(fan) + decodeScratchSize(largestStream(plan), plan.bytes);
}

lithe_result decodePage(const PageFormat& format, const PagePlan& plan, const uint8_t* bytes, size_t size,
                        Decoded* decoded, uint32_t* cursor, void* memory, lithe_diagnosis* diagnosis) {
  ScratchCursor scratch{static_cast<uint8_t*>(memory)};
  int32_t* values = scratch.take<int32_t>(plan.values);
  DecodeScratch cloud_scratch;
  cloud_scratch.size = decodeScratchSize(largestStream(plan), plan.bytes);
  cloud_scratch.memory = scratch.take<uint8_t>(cloud_scratch.size);

  const uint32_t nodes = decoded->node_count, wedges = decoded->wedge_count, faces = decoded->face_count;
  const uint32_t hidden = decoded->hidden_count;
  PageStreams streams = {};
  size_t offset = 0;
  uint32_t check = readStreams(format, plan, *decoded, bytes, size, values, cloud_scratch, &streams, &offset);
  if (check == 0) {
    uint32_t next = *cursor;
    check = applyPage(format, plan, &streams, &scratch, decoded, &next);
    if (check == 0) {
      *cursor = next;
      return LITHE_OK;
    }
    decoded->hidden_count = hidden;
    truncateDecoded(decoded, nodes, wedges, faces);
  }
  if (diagnosis) *diagnosis = {check, offset};
  return check == kCheckWork ? LITHE_ERROR_LIMIT : LITHE_ERROR_CORRUPT;
}

void truncateDecoded(Decoded* decoded, uint32_t node_count, uint32_t wedge_count, uint32_t face_count) {
  decoded->node_count = node_count;
  decoded->wedge_count = wedge_count;
  decoded->face_count = face_count;
  for (uint32_t n = 0; n < node_count; ++n) {
    decoded->node_first_corner[n] = kNoIndex;
    if (decoded->node_first_child[n] != kNoIndex && decoded->node_first_child[n] >= node_count)
      decoded->node_first_child[n] = kNoIndex;
  }
  for (uint32_t corner = 0; corner < 3 * face_count; ++corner) {
    uint32_t& wedge = decoded->face_wedges[corner];
    while (wedge >= wedge_count) wedge = decoded->wedge_parent[wedge];
    linkCorner(decoded, corner);
  }
}

}  // namespace lithe::runtime
