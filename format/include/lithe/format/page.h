// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// A page's payload: what the writer and the reader must agree on to the bit. docs/format.md is the specification.
///
///     kind (1 byte) | parameters (kParameterBytes) | table (varints) | streams | low bits of each kind | hidden
///
/// A *stream* is a Draco point cloud of `records` points with one or more integer attributes, without the beginning
/// that says so; or nothing (records 0).
#pragma once

#include <stdint.h>

#include "lithe/format/prediction.h"

namespace lithe::format {

// ---- Layout ----

enum PageKind : uint8_t { kBasePage = 0, kSplitPage = 1 };

/// Streams of a base page, in order.
enum BaseStream : uint32_t {
  kBaseNodes,       ///< per node: position delta x y z | wedge count - 1 | influence count - 1
  kBaseInfluences,  ///< per influence: joint | weight (the last weight of a node is written as 0 and derived)
  kBaseWedges,      ///< per wedge: part, and attribute deltas (all 16-bit values of the wedge's record)
  kBaseFaces,       ///< per face: three wedge deltas
  kBaseStreamCount
};

/// Streams of a split page, in order.
enum SplitStream : uint32_t {
  kFlagsOld,  ///< per node of an earlier level: split (1) or not (0)
  kFlagsNew,  ///< per node created by this level: split or not
  kSplits,    ///< per split: rank of t8 | lattice k across | lattice height | D residual across | height
  kCut3,      ///< per split with a closed ring of 3 edges: the pair of cut vertices; likewise 4, 5, 6, 7, 8, 9 or more
  kCut4,
  kCut5,
  kCut6,
  kCut7,
  kCut8,
  kCut9,
  kCutOpen,        ///< cut vertices of open rings
  kGeneral,        ///< the corners of child B and the new faces of irregular splits
  kClassesBoth,    ///< per wedge of a split node with corners at both children: how many wedges each child gets
  kClassesOne,     ///< the same for a wedge with corners at one child
  kClassesNone,    ///< the same for a wedge without corners
  kClassPicks,     ///< per new face: its class, where the split node has several and what lies beside suggests one
  kClassChoices,   ///< the same where it suggests none, or two
  kMemberPicks,    ///< a corner's wedge of a class at a child, where there are several and one is suggested
  kMemberChoices,  ///< the same where none is
  kThirdPicks,     ///< per new face: its wedge at the third node, where that has several and one is suggested
  kThirdChoices,   ///< the same where none is, or several are
  kNormals,        ///< per united wedge: high parts x y
  kTangents,       ///< per united wedge: high parts x y | sign flip
  kColors,         ///< per united wedge and set: r g b a
  kSkinModesAll,   ///< how the children's skins are said, where all of the ring's nodes have the node's skin
  kSkinModesMost,  ///< at least half of them
  kSkinModesSome,  ///< fewer
  kSkinModesNone,
  kSkinD,       ///< differences of the children's weights
  kSkinE,       ///< difference of child B's weights to the parent's, where the skin is free
  kSkinNew,     ///< counts of joints the parent lacks, and their ids
  kExtraMasks,  ///< per further wedge of a class: which attributes differ from the first one's
  kExtras,      ///< what these differ by from what is predicted, high parts
  kUv0,         ///< per united wedge: high parts x y; one stream per uv set
  kSplitStreamCount = kUv0 + 8
};

/// What low bits belong to. Each kind has its own bytes, so that what a kind takes is known without decoding.
enum LowBits : uint32_t { kLowPositions, kLowNormals, kLowTangents, kLowUvs, kLowSkins, kLowExtras, kLowBitsKinds };

/// The attributes of kSplits.
enum SplitAttribute : uint32_t { kSplitT8, kSplitLattice, kSplitLatticeHeight, kSplitPosition, kSplitPositionHeight };

/// One attribute of a stream's records. Unsigned values are >= 0.
struct StreamAttribute {
  uint8_t components;
  bool is_unsigned;
};

/// Which optional attributes an asset's wedges have.
struct WedgeAttributes {
  bool normals, tangents;
  uint32_t uv_sets, color_sets;
};

inline constexpr uint32_t kMaxStreamAttributes = 1 + 2 + 8 + 2;

/// The attributes of a stream's records; returns their number, 0 for a stream that this asset cannot have.
constexpr uint32_t baseStreamAttributes(uint32_t stream, WedgeAttributes has, StreamAttribute* out) {
  uint32_t n = 0;
  if (stream == kBaseNodes) {
    out[n++] = {3, false};
    out[n++] = {1, true};
    out[n++] = {1, true};
  } else if (stream == kBaseInfluences) {
    out[n++] = {1, true};
    out[n++] = {1, true};
  } else if (stream == kBaseWedges) {
    out[n++] = {1, true};
    if (has.normals) out[n++] = {2, false};
    if (has.tangents) out[n++] = {3, false};
    for (uint32_t s = 0; s < has.uv_sets; ++s) out[n++] = {2, false};
    for (uint32_t s = 0; s < has.color_sets; ++s) out[n++] = {4, false};
  } else if (stream == kBaseFaces) {
    out[n++] = {3, false};
  }
  return n;
}

constexpr uint32_t splitStreamAttributes(uint32_t stream, WedgeAttributes has, StreamAttribute* out) {
  uint32_t n = 0;
  if (stream == kSplits) {
    out[n++] = {1, true};   // rank of t8
    out[n++] = {2, false};  // lattice k across D
    out[n++] = {1, false};  // lattice k along D
    out[n++] = {2, false};  // D residual in the ring's plane, high parts
    out[n++] = {1, false};  // D residual off it, high parts
  } else if (stream == kNormals) {
    if (has.normals) out[n++] = {2, false};
  } else if (stream == kTangents) {
    if (has.tangents) out[n++] = {2, false}, out[n++] = {1, true};
  } else if (stream == kColors) {
    if (has.color_sets) out[n++] = {4, false};
  } else if (stream >= kUv0) {
    if (stream - kUv0 < has.uv_sets) out[n++] = {2, false};
  } else {
    out[n++] = {1, stream != kSkinD && stream != kSkinE && stream != kExtras};
  }
  return n;
}

/// Page parameters, one byte each; those of attributes that the asset lacks are zero.
enum Parameter : uint32_t {
  kPositionMean,     ///< prediction of D: sixteenths of the difference of the children's neighbourhoods [0, 32]
  kPositionBias,     ///< low bits of a D residual = max(0, bit length of the ring's edges - bias) [0, 31]
  kHeightBias,       ///< the same for its height over the ring's plane
  kPlacement,        ///< prediction of the lattice indices: sixteenths of what the children's planes say [0, 32]
  kNormalGradient,   ///< prediction of normals: sixteenths of the slope over the ring [0, 32]
  kNormalGeometry,   ///< and of the difference of the children's area normals [0, 32]
  kNormalBias,       ///< low bits of a normal's residual = max(0, bit length of the ring's spread - bias) [0, 31]
  kTangentGradient,  ///< as for normals
  kTangentBias,
  kSkinGradient,      ///< prediction of weights: sixteenths of the slope over the ring [0, 32]
  kSkinBias,          ///< as for normals
  kExtraNormalShift,  ///< low bits of a further wedge's normal [0, 15]
  kExtraTangentShift,
  kExtraUvShift,                ///< of all sets
  kUvGradient0,                 ///< prediction of uvs; one byte per uv set
  kUvBias0 = kUvGradient0 + 8,  ///< as for normals; one per set. Of a base page biases are numbers of low bits [0, 15]
  kParameterBytes = kUvBias0 + 8
};

/// Nodes with more wedges than this, or with a fan of more than kMaxRing corners, are split without prediction of
/// attributes, which bounds the reader's work.
inline constexpr uint32_t kMaxPredictedClasses = 8;

inline constexpr uint32_t kLowBitsMax = 15;
inline constexpr uint32_t kMaxRing = 64;            ///< larger fans are no rings
inline constexpr uint32_t kMaxPageWork = 1u << 26;  ///< corners visited while a page's splits are applied

/// Upper bounds on a split page's records that its own tables do not give: kGeneral and the picks.
constexpr uint64_t listedBound(uint64_t splits, uint64_t faces) { return 32 * (splits + faces); }
inline constexpr uint32_t kMaxSkinJoints = 24;  ///< joints of a parent and its two children together

/// What a closed ring's cut stream and kCutOpen say when sides and faces are listed one by one, as they always are for
/// a fan that is no ring; other values are one more than a pair of vertices or, in open rings, than a vertex or behind
/// these a pair.
inline constexpr uint32_t kCutListed = 0;

enum SkinMode : int32_t {
  kSkinSame = 0,  ///< both children have the parent's skin
  kSkinRule = 1,  ///< the parent's weights follow from the children's by t8
  kSkinFree = 2,  ///< both children are given against the parent
};

// ---- Arithmetic ----

constexpr int32_t lowBits(uint32_t extent, uint32_t bias) {
  const int32_t bits = bitLength(extent) - static_cast<int32_t>(bias);
  return bits < 0 ? 0 : bits > static_cast<int32_t>(kLowBitsMax) ? static_cast<int32_t>(kLowBitsMax) : bits;
}

/// Unordered pairs 0 <= p < q < n, numbered by q, then p.
constexpr uint32_t pairIndex(uint32_t p, uint32_t q) { return q * (q - 1) / 2 + p; }
constexpr void pairOf(uint32_t index, uint32_t* p, uint32_t* q) {
  uint32_t high = 1;
  while (high * (high + 1) / 2 <= index) ++high;
  *q = high;
  *p = index - high * (high - 1) / 2;
}

/// How many wedges a split node's wedge becomes at either child.
struct ClassCounts {
  uint32_t a, b;
};

/// Up to kMostCodedWedges of them are one code: pairs are numbered by their sum, then by the second, which is the far
/// child's for a wedge that has corners at one child only, else child B's. Code kClassListed is followed by both.
inline constexpr uint32_t kMostCodedWedges = 12;
inline constexpr uint32_t kClassListed = pairIndex(0, kMostCodedWedges + 2) - 1;

constexpr bool classIsTurned(bool at_a, bool at_b) { return at_b && !at_a; }
constexpr ClassCounts turnedIf(bool turned, ClassCounts c) { return turned ? ClassCounts{c.b, c.a} : c; }

constexpr uint32_t classCode(ClassCounts counts, bool at_a, bool at_b) {
  const uint64_t sum = uint64_t{counts.a} + counts.b;
  const ClassCounts c = turnedIf(classIsTurned(at_a, at_b), counts);
  return sum > kMostCodedWedges ? kClassListed : pairIndex(c.b, static_cast<uint32_t>(sum) + 1) - 1;
}

/// code < kClassListed
constexpr ClassCounts classCounts(uint32_t code, bool at_a, bool at_b) {
  uint32_t second = 0, after = 0;
  pairOf(code + 1, &second, &after);
  return turnedIf(classIsTurned(at_a, at_b), {after - 1 - second, second});
}

/// The stream of a class, by the children at which it has corners.
constexpr uint32_t classStream(bool at_a, bool at_b) {
  return at_a != at_b ? kClassesOne : at_a ? kClassesBoth : kClassesNone;
}

/// The stream of cut vertices for a closed ring of n edges.
constexpr uint32_t cutStream(uint32_t n) { return n >= 9 ? static_cast<uint32_t>(kCut9) : kCut3 + (n < 3 ? 0 : n - 3); }

/// The bits of kExtraMasks: which attributes of a class's further wedge differ from the first one's.
inline constexpr uint32_t kMaskNormal = 0, kMaskTangent = 1, kMaskUv0 = 2, kMaskColor0 = 10, kMaskEnd = 12;

// ---- Rings ----

/// The faces around a node w in the current cut: corner ids (3 * face + k) in ascending order, and for each the nodes
/// of the next and the previous corner of its face. Seen from w, the face's edge runs from `next` to `previous`.
struct Fan {
  uint32_t count;
  uint32_t* corner;
  uint32_t* next;
  uint32_t* previous;
};

enum class RingKind { kClosed, kOpen, kIrregular };

/// The stream of a split's skin mode: `alike` of the fan's corners have a next node with the split node's skin.
constexpr uint32_t skinModeStream(uint32_t alike, uint32_t corners) {
  if (alike == corners) return kSkinModesAll;
  if (2 * alike >= corners) return kSkinModesMost;
  return alike > 0 ? kSkinModesSome : kSkinModesNone;
}

/// The mean length of the edges to the next corners' nodes, each as its longest component; 0 without any.
template <class NextPosition>
constexpr uint32_t meanEdge(const Fan& fan, Int3 center, const NextPosition& next_position) {
  int64_t sum = 0;
  for (uint32_t i = 0; i < fan.count; ++i) sum += longest(minus(next_position(i), center));
  return fan.count ? static_cast<uint32_t>(sum / fan.count) : 0;
}

/// The ring's vertex that pairs of cut vertices are counted from, because cuts end there most often: the farthest from
/// the split node, in the largest component; the first of equal ones. edge_begins(i): where edge i of the fan begins.
template <class Ring, class EdgeBegins>
constexpr uint32_t farthestVertex(const Ring& ring, Int3 center, const EdgeBegins& edge_begins) {
  uint32_t farthest = 0;
  int32_t most = -1;
  for (uint32_t v = 0; v < ring.count; ++v) {
    const int32_t distance = longest(minus(edge_begins(ring.edge[v]), center));
    if (distance <= most) continue;
    most = distance;
    farthest = v;
  }
  return farthest;
}

/// A fan put in order: edge i runs from vertex i to vertex i + 1 (modulo count when closed; an open ring has count + 1
/// vertices).
struct Ring {
  RingKind kind;
  uint32_t count;          ///< edges
  uint8_t edge[kMaxRing];  ///< index into the fan
  uint32_t vertex[kMaxRing + 1];
};

/// The first edge that begins where edge i ends, or the fan's count.
inline uint32_t edgeAfter(const Fan& fan, uint32_t i) {
  // Looks at all of them: where a search stops cannot be foreseen, and costs a processor more than the rest of it.
  const uint32_t node = fan.previous[i];
  uint32_t after = 0, found = 0;
  for (uint32_t j = 0; j < fan.count; ++j) {
    found |= fan.next[j] == node;
    after += found ^ 1;
  }
  return after;
}

/// Goes on from an edge until there is no next one or it is back; returns where it stands then: an edge, or the fan's
/// count. Fills the ring as far as it comes, at most to the fan's count.
inline uint32_t walkRing(const Fan& fan, uint32_t start, Ring& ring) {
  uint32_t at = start, length = 0;
  do {
    ring.edge[length] = static_cast<uint8_t>(at);
    ring.vertex[length] = fan.next[at];
    ring.vertex[++length] = fan.previous[at];
    at = edgeAfter(fan, at);
  } while (at != fan.count && at != start && length < fan.count);
  ring.count = length;
  return at;
}

/// The edge before which there is none, going back from the fan's first; the fan's count when it goes round.
inline uint32_t openEnd(const Fan& fan) {
  uint32_t at = 0;
  for (uint32_t step = 0; step < fan.count; ++step) {
    uint32_t before = 0;
    while (before < fan.count && fan.previous[before] != fan.next[at]) ++before;
    if (before == fan.count) return at;
    at = before;
  }
  return fan.count;
}

/// Orders a fan. A closed ring begins with the fan's first corner, an open one at its open end. Irregular: no corners,
/// more than kMaxRing, a vertex left or entered twice, or more than one chain.
inline void buildRing(const Fan& fan, Ring& ring) {
  ring.kind = RingKind::kIrregular;
  const uint32_t n = ring.count = fan.count;
  if (n == 0 || n > kMaxRing) return;
  // A walk goes on to the first edge that begins where the last one ended: one that comes past all edges has met no
  // vertex twice, since a second edge at a vertex is never gone on to.
  if (walkRing(fan, 0, ring) == 0 && ring.count == n) {
    ring.kind = RingKind::kClosed;
  } else if (const uint32_t start = openEnd(fan); start != n) {
    if (walkRing(fan, start, ring) == n && ring.count == n) ring.kind = RingKind::kOpen;
  }
  ring.count = n;
}

}  // namespace lithe::format
