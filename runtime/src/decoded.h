// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What has been decoded of an asset: append-only arrays in the order of the file, coarse to fine.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace lithe::runtime {

/// Up to eight influences of a node; weights sum to 2^weight_bits - 1, sorted by descending weight.
struct NodeSkin {
  uint32_t count;
  uint16_t joint[8];
  uint16_t weight[8];
};

/// How much the records of an asset hold.
struct RecordWidths {
  uint32_t attributes;  ///< WedgeLayout::stride
  uint32_t influences;  ///< of the file, at most eight
};

/// Skins as they are kept, a record of 2 * influences values per node: joints, then weights; those beyond a skin's
/// count are zero.
struct SkinRecord {
  const uint16_t* joint;
  const uint16_t* weight;
  uint32_t most;

  uint32_t count() const {
    uint32_t count = 1;
    while (count < most && weight[count] > 0) ++count;
    return count;
  }

  /// 0 for a joint that has none.
  int32_t weightOf(uint32_t of_joint) const {
    int32_t found = 0;  // without branches: which joint it is cannot be foreseen
    for (uint32_t k = 0; k < most; ++k) found += weight[k] & -static_cast<int32_t>(joint[k] == of_joint);
    return found;
  }
};

/// Attributes of a wedge, `stride` int16/uint16 values each, in this order: normal x y, tangent x y sign, uv0 x y, ...,
/// colour0 r g b a, ... (only those the asset has). 16-bit integers as the file's quantisation gives them.
struct WedgeLayout {
  uint32_t stride;  ///< 16-bit values per wedge
  uint32_t normal;  ///< position of each attribute in the record; kNoAttribute when absent
  uint32_t tangent;
  uint32_t uv[8];
  uint32_t color[2];
};
inline constexpr uint32_t kNoAttribute = 0xffffffffu;

/// Capacities follow the level table: growing to a level allocates exactly that level's counts.
struct Decoded {
  uint32_t node_count, wedge_count, face_count;  ///< valid entries
  uint32_t node_capacity, wedge_capacity, face_capacity;

  uint16_t* node_position;     ///< 3 per node, grid coordinates
  uint32_t* node_parent;       ///< kNoIndex for roots
  uint32_t* node_first_child;  ///< children are this and this + 1; kNoIndex while unsplit
  uint32_t* node_first_wedge;  ///< node_count + 1 entries: wedges [first(n), first(n + 1)) are node n's
  uint16_t* node_skin;         ///< 2 * influences per node, see SkinRecord
  uint32_t*
      node_first_corner;  ///< head of the list of the corners (3 * face + k) at a node of the current cut; kNoIndex

  uint32_t* wedge_node;
  uint32_t* wedge_parent;  ///< kNoIndex in the base
  uint16_t* wedge_part;
  uint16_t* wedge_attributes;  ///< WedgeLayout::stride per wedge

  uint32_t* face_wedges;  ///< 3 per face, of the finest resident cut
  uint32_t* corner_next;  ///< 3 per face: next corner at the same node, kNoIndex at the end

  /// Faces not drawn: per resident level a run of ascending face ids.
  uint32_t* hidden_faces;
  uint32_t hidden_count, hidden_capacity;
  uint32_t hidden_end[64];  ///< per level: end of its run (it starts at the end of the level before)
};

inline SkinRecord skinOf(const Decoded& decoded, uint32_t node, uint32_t influences) {
  const uint16_t* record = decoded.node_skin + size_t{2} * influences * node;
  return {record, record + influences, influences};
}

inline void storeSkin(const NodeSkin& skin, uint32_t node, uint32_t influences, Decoded* decoded) {
  uint16_t* record = decoded->node_skin + size_t{2} * influences * node;
  for (uint32_t i = 0; i < influences; ++i) {
    record[i] = i < skin.count ? skin.joint[i] : uint16_t{0};
    record[influences + i] = i < skin.count ? skin.weight[i] : uint16_t{0};
  }
}

}  // namespace lithe::runtime
