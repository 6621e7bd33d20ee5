// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "isosurface.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "lattice_warp.h"
#include "lithe/bake/model.h"
#include "mesh_relax.h"

namespace lithe::bake {
namespace {

constexpr int kBlock = 8;  ///< cells along the edge of a block
constexpr int kBlockCells = kBlock * kBlock * kBlock;
constexpr int kBlockPoints = (kBlock + 1) * (kBlock + 1) * (kBlock + 1);

/// For each of the 256 patterns of corners inside: how the crossed edges of a cell group into sheets.
/// Corner c lies at (c & 1, c >> 1 & 1, c >> 2); edge 4a + i + 2j runs along axis a at offset i of axis a + 1, j of
/// axis a + 2.
struct CellPatterns {
  std::array<std::array<int8_t, 12>, 256> sheet_of_edge;
  std::array<uint8_t, 256> sheet_count;
};

int cornerOf(int axis, int along, int i, int j) {
  return (along << axis) | (i << ((axis + 1) % 3)) | (j << ((axis + 2) % 3));
}

/// The edge between two corners that differ in one coordinate.
int edgeBetween(int corner, int other) {
  const int axis = (corner ^ other) >> 1;  // 1, 2, 4 -> 0, 1, 2
  const int low = std::min(corner, other);
  return 4 * axis + ((low >> ((axis + 1) % 3)) & 1) + 2 * ((low >> ((axis + 2) % 3)) & 1);
}

/// Joins the edges on either side of every inside corner of a face whose diagonal neighbour is treated as apart from
/// it, and the two edges of a face with two crossings. What is decided on a face is the same for the two cells that
/// share it.
void joinAcrossFace(int pattern, const std::array<int, 4>& loop, std::array<int, 12>& group) {
  const auto join = [&](int a, int b) {
    const int from = std::max(group[a], group[b]), to = std::min(group[a], group[b]);
    std::replace(group.begin(), group.end(), from, to);
  };
  std::vector<int> crossed;
  for (int k = 0; k < 4; ++k) {
    if (((pattern >> loop[k]) & 1) != ((pattern >> loop[(k + 1) % 4]) & 1)) crossed.push_back(k);
  }
  if (crossed.size() == 2) {
    join(edgeBetween(loop[crossed[0]], loop[(crossed[0] + 1) % 4]),
         edgeBetween(loop[crossed[1]], loop[(crossed[1] + 1) % 4]));
  } else if (crossed.size() == 4) {
    for (int k = 0; k < 4; ++k) {
      if (!((pattern >> loop[k]) & 1)) continue;
      join(edgeBetween(loop[k], loop[(k + 1) % 4]), edgeBetween(loop[(k + 3) % 4], loop[k]));
    }
  }
}

CellPatterns makePatterns() {
  CellPatterns patterns{};
  for (int pattern = 0; pattern < 256; ++pattern) {
    std::array<int, 12> group{};
    for (int edge = 0; edge < 12; ++edge) group[edge] = edge;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 2; ++side) {
        joinAcrossFace(pattern,
                       {cornerOf(axis, side, 0, 0), cornerOf(axis, side, 1, 0), cornerOf(axis, side, 1, 1),
                        cornerOf(axis, side, 0, 1)},
                       group);
      }
    }
    std::array<int8_t, 12> number_of_group;
    number_of_group.fill(-1);
    for (int edge = 0; edge < 12; ++edge) {
      const int axis = edge / 4, i = edge & 1, j = (edge >> 1) & 1;
      const int low = cornerOf(axis, 0, i, j), high = cornerOf(axis, 1, i, j);
      patterns.sheet_of_edge[pattern][edge] = -1;
      if (((pattern >> low) & 1) == ((pattern >> high) & 1)) continue;
      int8_t& number = number_of_group[group[edge]];
      if (number < 0) number = static_cast<int8_t>(patterns.sheet_count[pattern]++);
      patterns.sheet_of_edge[pattern][edge] = number;
    }
  }
  return patterns;
}

/// One block of the lattice that the surface passes through.
struct Block {
  glm::ivec3 first{0};  ///< its low corner, in cells
  std::vector<uint32_t> active;
  std::array<uint8_t, kBlockCells> pattern{};
  std::array<uint32_t, kBlockCells> first_vertex{};
};

class Polygoniser {
 public:
  Polygoniser(const implicit::Solid& solid, const PolygoniseOptions& options)
      : solid_(solid), cell_(options.cell), warp_(spotsOf(options)), patterns_(makePatterns()) {
    glm::dvec3 low, high;
    solid.bounds(low, high);
    origin_ = low - warp_.largestShift() - 2.0 * cell_;
    const glm::dvec3 size = high + warp_.largestShift() + 2.0 * cell_ - origin_;
    for (int k = 0; k < 3; ++k) blocks_along_[k] = static_cast<int>(std::ceil(size[k] / (cell_ * kBlock)));
    slot_.assign(static_cast<size_t>(blocks_along_.x) * blocks_along_.y * blocks_along_.z, kNone);
  }

  ClosedMesh run(uint32_t relaxations) {
    findBlocks();
    for (uint32_t slot = 0; slot < blocks_.size(); ++slot) sampleBlock(slot);
    for (const Block& block : blocks_) addQuads(block);
    keepLargestPiece();
    relax(relaxations);
    finish();
    return std::move(mesh_);
  }

 private:
  static std::vector<LatticeWarp::Spot> spotsOf(const PolygoniseOptions& options) {
    std::vector<LatticeWarp::Spot> spots;
    for (const DenseSpot& spot : options.spots) spots.push_back({spot.center, spot.radius, spot.magnification});
    return spots;
  }

  glm::dvec3 latticePoint(const glm::dvec3& q) const { return origin_ + cell_ * q; }

  uint32_t& slotAt(const glm::ivec3& block) {
    return slot_[(static_cast<size_t>(block.z) * blocks_along_.y + block.y) * blocks_along_.x + block.x];
  }

  /// The farthest that a block's corners are from its middle, in model space.
  double blockRadius(const glm::ivec3& first, const glm::dvec3& middle) const {
    double radius2 = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 place = first + kBlock * glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
      const glm::dvec3 d = warp_.toModel(latticePoint(glm::dvec3(place))) - middle;
      radius2 = std::max(radius2, glm::dot(d, d));
    }
    return std::sqrt(radius2);
  }

  /// Keeps the blocks whose middle is not farther from the surface than their corners are from the middle.
  void findBlocks() {
    constexpr double kSlack = 1.3;  // distances to squeezed solids may be too large by less than this
    for (int z = 0; z < blocks_along_.z; ++z) {
      for (int y = 0; y < blocks_along_.y; ++y) {
        for (int x = 0; x < blocks_along_.x; ++x) {
          const glm::ivec3 at(x, y, z);
          const glm::dvec3 middle = warp_.toModel(latticePoint(glm::dvec3(at) * double(kBlock) + 0.5 * kBlock));
          const double radius = kSlack * blockRadius(at * kBlock, middle);
          Block block;
          block.active = solid_.activeNear(middle, radius);
          if (block.active.empty()) continue;
          if (std::fabs(solid_.sample(middle, block.active).distance) > radius) continue;
          block.first = at * kBlock;
          slotAt(at) = static_cast<uint32_t>(blocks_.size());
          blocks_.push_back(std::move(block));
        }
      }
    }
  }

  static int pointIndex(int x, int y, int z) { return (z * (kBlock + 1) + y) * (kBlock + 1) + x; }
  static int cellIndex(const glm::ivec3& c) { return (c.z * kBlock + c.y) * kBlock + c.x; }

  void sampleBlock(uint32_t slot) {
    Block& block = blocks_[slot];
    std::array<double, kBlockPoints> value;
    for (int z = 0; z <= kBlock; ++z) {
      for (int y = 0; y <= kBlock; ++y) {
        for (int x = 0; x <= kBlock; ++x) {
          const glm::dvec3 point = warp_.toModel(latticePoint(glm::dvec3(block.first + glm::ivec3(x, y, z))));
          value[pointIndex(x, y, z)] = solid_.sample(point, block.active).distance;
        }
      }
    }
    for (int z = 0; z < kBlock; ++z) {
      for (int y = 0; y < kBlock; ++y) {
        for (int x = 0; x < kBlock; ++x) addCell(slot, {x, y, z}, value);
      }
    }
  }

  void addCell(uint32_t slot, const glm::ivec3& cell, const std::array<double, kBlockPoints>& value) {
    Block& block = blocks_[slot];
    std::array<double, 8> corner_value;
    int pattern = 0;
    for (int corner = 0; corner < 8; ++corner) {
      corner_value[corner] =
          value[pointIndex(cell.x + (corner & 1), cell.y + ((corner >> 1) & 1), cell.z + (corner >> 2))];
      pattern |= (corner_value[corner] < 0.0) << corner;
    }
    block.pattern[cellIndex(cell)] = static_cast<uint8_t>(pattern);
    block.first_vertex[cellIndex(cell)] = static_cast<uint32_t>(mesh_.positions.size());
    for (int sheet = 0; sheet < patterns_.sheet_count[pattern]; ++sheet) {
      mesh_.positions.push_back(warp_.toModel(latticePoint(
          glm::dvec3(block.first + cell) + middleOfCrossings(corner_value, patterns_.sheet_of_edge[pattern], sheet))));
      block_of_vertex_.push_back(slot);
    }
  }

  static glm::dvec3 middleOfCrossings(const std::array<double, 8>& value, const std::array<int8_t, 12>& sheet_of_edge,
                                      int sheet) {
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (int edge = 0; edge < 12; ++edge) {
      if (sheet_of_edge[edge] != sheet) continue;
      const int axis = edge / 4;
      const int low = cornerOf(axis, 0, edge & 1, (edge >> 1) & 1), high = low | (1 << axis);
      glm::dvec3 crossing(low & 1, (low >> 1) & 1, low >> 2);
      crossing[axis] = value[low] / (value[low] - value[high]);
      sum += crossing;
      count += 1.0;
    }
    return sum / count;
  }

  /// The vertex that the sheet through one edge has in the cell at `place` (in cells of the whole lattice).
  uint32_t vertexAt(const glm::ivec3& place, int edge) {
    const uint32_t slot = slotAt(place / kBlock);
    const int cell = slot == kNone ? 0 : cellIndex(place - blocks_[slot].first);
    const int sheet = slot == kNone ? -1 : patterns_.sheet_of_edge[blocks_[slot].pattern[cell]][edge];
    if (sheet < 0)
      throw Error("generate: two blocks of the lattice disagree about the surface; widen kBlendReach or kSlack.");
    return blocks_[slot].first_vertex[cell] + static_cast<uint32_t>(sheet);
  }

  void addQuads(const Block& block) {
    for (int z = 0; z < kBlock; ++z) {
      for (int y = 0; y < kBlock; ++y) {
        for (int x = 0; x < kBlock; ++x) {
          const int pattern = block.pattern[cellIndex({x, y, z})];
          for (int axis = 0; axis < 3; ++axis) {
            const bool low_inside = pattern & 1, high_inside = (pattern >> (1 << axis)) & 1;
            if (low_inside != high_inside) addQuad(block.first + glm::ivec3(x, y, z), axis, low_inside);
          }
        }
      }
    }
  }

  /// The four cells around the edge that leaves `place` along `axis`; counter-clockwise seen from the axis' end.
  void addQuad(const glm::ivec3& place, int axis, bool faces_forward) {
    glm::ivec3 b(0), c(0);
    b[(axis + 1) % 3] = 1;
    c[(axis + 2) % 3] = 1;
    std::array<uint32_t, 4> quad = {vertexAt(place, 4 * axis), vertexAt(place - b, 4 * axis + 1),
                                    vertexAt(place - b - c, 4 * axis + 3), vertexAt(place - c, 4 * axis + 2)};
    if (!faces_forward) std::swap(quad[1], quad[3]);
    const auto length2 = [&](int i, int j) {
      const glm::dvec3 d = mesh_.positions[quad[i]] - mesh_.positions[quad[j]];
      return glm::dot(d, d);
    };
    if (length2(0, 2) <= length2(1, 3)) {
      mesh_.triangles.push_back({quad[0], quad[1], quad[2]});
      mesh_.triangles.push_back({quad[0], quad[2], quad[3]});
    } else {
      mesh_.triangles.push_back({quad[1], quad[2], quad[3]});
      mesh_.triangles.push_back({quad[1], quad[3], quad[0]});
    }
  }

  /// Drops what hangs in the air and what is hollowed out inside.
  void keepLargestPiece() {
    const uint32_t count = static_cast<uint32_t>(mesh_.positions.size());
    std::vector<uint32_t> piece = connectedPieces(count, mesh_.triangles), size(count, 0), place(count, kNone);
    for (uint32_t v = 0; v < count; ++v) ++size[piece[v]];
    const auto largest = static_cast<uint32_t>(std::max_element(size.begin(), size.end()) - size.begin());
    uint32_t kept = 0;
    for (uint32_t v = 0; v < count; ++v) {
      if (piece[v] != largest) continue;
      place[v] = kept;
      mesh_.positions[kept] = mesh_.positions[v];
      block_of_vertex_[kept++] = block_of_vertex_[v];
    }
    mesh_.positions.resize(kept);
    block_of_vertex_.resize(kept);
    std::erase_if(mesh_.triangles, [&](const auto& t) { return place[t[0]] == kNone; });
    for (auto& triangle : mesh_.triangles) {
      for (uint32_t& vertex : triangle) vertex = place[vertex];
    }
  }

  implicit::Sample sampleAt(uint32_t vertex, const glm::dvec3& point) const {
    const uint32_t first = active_first_[vertex];
    return solid_.sample(point, std::span(active_).subspan(first, active_first_[vertex + 1] - first));
  }

  /// Newton's steps along the gradient, none longer than a cell.
  glm::dvec3 ontoSurface(uint32_t vertex, glm::dvec3 point, int steps) const {
    for (int step = 0; step < steps; ++step) {
      const implicit::Sample s = sampleAt(vertex, point);
      const double g2 = std::max(0.04, glm::dot(s.gradient, s.gradient));
      point -= s.gradient * glm::clamp(s.distance / g2, -cell_, cell_);
    }
    return point;
  }

  /// Narrows a block's list of primitives down to those that matter where each vertex can move to.
  void narrowActive() {
    active_first_.push_back(0);
    for (uint32_t v = 0; v < mesh_.positions.size(); ++v) {
      const std::vector<uint32_t>& candidates = blocks_[block_of_vertex_[v]].active;
      for (uint32_t i : solid_.activeAt(mesh_.positions[v], 2.0 * cell_, candidates)) active_.push_back(i);
      active_first_.push_back(static_cast<uint32_t>(active_.size()));
    }
  }

  void relax(uint32_t rounds) {
    narrowActive();
    for (uint32_t v = 0; v < mesh_.positions.size(); ++v) mesh_.positions[v] = ontoSurface(v, mesh_.positions[v], 2);
    for (uint32_t round = 0; round < rounds; ++round) {
      const std::vector<glm::dvec3> target = neighbourhoodCenters(mesh_.positions, mesh_.triangles);
      for (uint32_t v = 0; v < mesh_.positions.size(); ++v) {
        const glm::dvec3 gradient = sampleAt(v, mesh_.positions[v]).gradient;
        const glm::dvec3 normal = gradient / std::sqrt(std::max(1e-12, glm::dot(gradient, gradient)));
        const glm::dvec3 move = target[v] - mesh_.positions[v];
        mesh_.positions[v] = ontoSurface(v, mesh_.positions[v] + 0.7 * (move - normal * glm::dot(move, normal)), 1);
      }
      if (round % 3 == 2) flipEdges(mesh_.positions, mesh_.triangles);
    }
    for (uint32_t v = 0; v < mesh_.positions.size(); ++v) mesh_.positions[v] = ontoSurface(v, mesh_.positions[v], 2);
  }

  void finish() {
    for (uint32_t v = 0; v < mesh_.positions.size(); ++v) {
      mesh_.normals.push_back(glm::normalize(sampleAt(v, mesh_.positions[v]).gradient));
      mesh_.labels.push_back(solid_.labelAt(mesh_.positions[v], blocks_[block_of_vertex_[v]].active));
    }
  }

  const implicit::Solid& solid_;
  const double cell_;
  const LatticeWarp warp_;
  const CellPatterns patterns_;
  glm::dvec3 origin_{0.0};
  glm::ivec3 blocks_along_{0};
  std::vector<uint32_t> slot_;  ///< per block of the whole lattice, index into blocks_ or kNone
  std::vector<Block> blocks_;
  std::vector<uint32_t> block_of_vertex_;
  std::vector<uint32_t> active_, active_first_;  ///< per vertex, the primitives that matter near it
  ClosedMesh mesh_;
};

}  // namespace

ClosedMesh polygonise(const implicit::Solid& solid, const PolygoniseOptions& options) {
  return Polygoniser(solid, options).run(options.relaxations);
}

}  // namespace lithe::bake
