// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "contour_cut.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

namespace lithe::bake {
namespace {

using Triangle = std::array<uint32_t, 3>;

/// A vertex moves if the curve crosses one of its edges within this share of the edge's length.
constexpr double kSnap = 0.3;

class Cutter {
 public:
  Cutter(ClosedMesh& mesh, std::vector<double>& value) : mesh_(mesh), value_(value) {}

  std::vector<uint32_t> run() {
    snapVertices();
    splitTriangles();
    std::sort(touched_.begin(), touched_.end());
    return std::move(touched_);
  }

 private:
  /// Moving `vertex` along its edge to `other` by a share of it brings it onto the curve.
  struct Move {
    double share;
    uint32_t vertex, other;
  };

  bool crossed(uint32_t a, uint32_t b) const {
    return (value_[a] < 0.0 && value_[b] > 0.0) || (value_[a] > 0.0 && value_[b] < 0.0);
  }
  double shareOf(uint32_t a, uint32_t b) const { return value_[a] / (value_[a] - value_[b]); }

  std::vector<Move> possibleMoves() const {
    std::vector<Move> moves;
    for (const Triangle& t : mesh_.triangles) {
      for (int k = 0; k < 3; ++k) {
        const uint32_t a = t[k], b = t[(k + 1) % 3];
        if (!crossed(a, b)) continue;
        const double share = shareOf(a, b);
        if (share < kSnap) moves.push_back({share, a, b});
        if (1.0 - share < kSnap) moves.push_back({1.0 - share, b, a});
      }
    }
    std::sort(moves.begin(), moves.end(), [](const Move& x, const Move& y) {
      return std::tie(x.share, x.vertex, x.other) < std::tie(y.share, y.vertex, y.other);
    });
    return moves;
  }

  /// The triangles at vertices that the curve passes.
  std::unordered_map<uint32_t, std::vector<uint32_t>> trianglesAt(const std::vector<Move>& moves) const {
    std::unordered_map<uint32_t, std::vector<uint32_t>> triangles;  // only looked up, never walked through
    for (const Move& move : moves) triangles[move.vertex];
    for (uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (const uint32_t corner : mesh_.triangles[t]) {
        const auto found = triangles.find(corner);
        if (found != triangles.end()) found->second.push_back(t);
      }
    }
    return triangles;
  }

  /// A triangle with all corners on the curve would be a tooth of it.
  bool makesATooth(const std::vector<uint32_t>& triangles) const {
    return std::any_of(triangles.begin(), triangles.end(), [&](uint32_t t) {
      const auto onCurve = [&](uint32_t corner) { return value_[corner] == 0.0; };
      return std::count_if(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), onCurve) >= 2;
    });
  }

  void snapVertices() {
    const std::vector<Move> moves = possibleMoves();
    const auto triangles = trianglesAt(moves);
    for (const Move& move : moves) {
      if (value_[move.vertex] == 0.0 || value_[move.other] == 0.0) continue;
      if (makesATooth(triangles.at(move.vertex))) continue;
      mesh_.positions[move.vertex] = glm::mix(mesh_.positions[move.vertex], mesh_.positions[move.other], move.share);
      mesh_.normals[move.vertex] = mixedNormal(move.vertex, move.other, move.share);
      value_[move.vertex] = 0.0;
      touched_.push_back(move.vertex);
    }
  }

  glm::dvec3 mixedNormal(uint32_t a, uint32_t b, double share) const {
    return glm::normalize(glm::mix(mesh_.normals[a], mesh_.normals[b], share));
  }

  /// The new vertex on a crossed edge, the same from both sides.
  uint32_t middleOf(uint32_t from, uint32_t to) {
    const uint32_t a = std::min(from, to), b = std::max(from, to);
    const uint32_t next = static_cast<uint32_t>(mesh_.positions.size());
    const auto [entry, is_new] = middles_.try_emplace(uint64_t{a} << 32 | b, next);
    if (!is_new) return entry->second;
    const double share = shareOf(a, b);
    mesh_.positions.push_back(glm::mix(mesh_.positions[a], mesh_.positions[b], share));
    mesh_.normals.push_back(mixedNormal(a, b, share));
    mesh_.labels.push_back(mesh_.labels[share < 0.5 ? a : b]);
    value_.push_back(0.0);
    touched_.push_back(next);
    return next;
  }

  void splitTriangles() {
    std::vector<Triangle> pieces;
    pieces.reserve(mesh_.triangles.size());
    for (const Triangle& triangle : mesh_.triangles) addPieces(triangle, pieces);
    mesh_.triangles = std::move(pieces);
  }

  void addPieces(Triangle t, std::vector<Triangle>& pieces) {
    const int count = crossed(t[0], t[1]) + crossed(t[1], t[2]) + crossed(t[2], t[0]);
    if (count == 0) {
      pieces.push_back(t);
    } else if (count == 1) {
      while (!crossed(t[1], t[2])) std::rotate(t.begin(), t.begin() + 1, t.end());
      const uint32_t m = middleOf(t[1], t[2]);
      pieces.push_back({t[0], t[1], m});
      pieces.push_back({t[0], m, t[2]});
    } else {
      while (crossed(t[1], t[2])) std::rotate(t.begin(), t.begin() + 1, t.end());  // t[0] is alone on its side
      const uint32_t m = middleOf(t[0], t[1]), n = middleOf(t[2], t[0]);
      pieces.push_back({t[0], m, n});
      addQuad({m, t[1], t[2], n}, pieces);
    }
  }

  void addQuad(const std::array<uint32_t, 4>& q, std::vector<Triangle>& pieces) const {
    const auto length2 = [&](uint32_t a, uint32_t b) {
      const glm::dvec3 d = mesh_.positions[a] - mesh_.positions[b];
      return glm::dot(d, d);
    };
    const int first = length2(q[0], q[2]) <= length2(q[1], q[3]) ? 0 : 1;
    pieces.push_back({q[first], q[first + 1], q[first + 2]});
    pieces.push_back({q[first], q[first + 2], q[(first + 3) % 4]});
  }

  ClosedMesh& mesh_;
  std::vector<double>& value_;
  std::vector<uint32_t> touched_;
  std::unordered_map<uint64_t, uint32_t> middles_;  ///< only looked up, never walked through
};

}  // namespace

std::vector<uint32_t> cutAlong(ClosedMesh& mesh, std::vector<double>& value) { return Cutter(mesh, value).run(); }

}  // namespace lithe::bake
