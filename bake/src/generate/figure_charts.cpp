// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Texture charts of the body: pieces that follow the limbs, cut where a tailor would, unrolled or flattened, and
/// packed.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "chart_packing.h"
#include "exact_math.h"
#include "figure.h"
#include "mesh_relax.h"
#include "tube.h"

namespace lithe::bake::figure {
namespace {

using glm::dvec2;
using glm::dvec3;

/// The pieces of the body that share a way of unrolling. Those of a side exist twice.
enum Region : uint32_t {
  kFace,
  kSkull,
  kThroat,
  kFront,
  kBack,
  kArm,
  kPalm,
  kHandBack,
  kLeg,
  kInstep,
  kSole,
  kRegions
};

inline uint32_t chartOf(Region region, bool right) { return 2 * region + (right ? 1 : 0); }

/// u in turns for what is unrolled around an axis (a triangle across the cut continues above 1), metres otherwise.
struct ChartPoint {
  dvec2 uv;
  double metres_per_turn = 0.0;  ///< 0: not unrolled
};

double lengthOf(const dvec3& v) { return std::sqrt(glm::dot(v, v)); }

/// The share of a turn from the cut direction, in [0, 1).
double turns(double sine, double cosine) {
  const double t = exact::arcTangent2(sine, cosine) / exact::kTau;
  return t < 0.0 ? t + 1.0 : t;
}

/// Half of the head, seen from in front or behind; equal areas (Lambert).
ChartPoint headPoint(const dvec3& p, double facing) {
  constexpr double kRadius = 0.1;
  const dvec3 d = glm::normalize(p - dvec3(0.0, 1.64, -0.02));
  const double rim = std::sqrt(std::max(1e-12, d.x * d.x + d.y * d.y));
  const double radius = kRadius * std::sqrt(std::max(0.0, 2.0 * (1.0 - facing * d.z)));
  return {{facing * d.x / rim * radius, d.y / rim * radius}};
}

/// Half of the trunk unrolled around the spine; level ground at shoulders and crotch is tilted so that it keeps some
/// area.
ChartPoint trunkPoint(const dvec3& p, double facing) {
  constexpr double kRadius = 0.15, kTilt = 0.35;
  const double x = p.x * facing, z = (p.z + 0.015) * facing;
  const double radius = std::sqrt(x * x + z * z);
  const double top = exact::smoothStep(1.15, 1.45, p.y), bottom = 1.0 - exact::smoothStep(0.85, 1.10, p.y);
  return {{kRadius * exact::arcTangent2(x, z), p.y + kTilt * radius * (bottom - top)}};
}

ChartPoint throatPoint(const dvec3& p) { return {{turns(-p.x, -(p.z + 0.03)), p.y}, exact::kTau * 0.056}; }

ChartPoint armPoint(const dvec3& p, const Anatomy& a) {
  const dvec3 axis = glm::normalize(a.wrist - a.shoulder);
  const dvec3 front = glm::normalize(dvec3(0, 0, 1) - axis * axis.z), down = glm::cross(axis, front);
  const dvec3 from = p - a.shoulder;
  return {{turns(glm::dot(from, front), glm::dot(from, down)), glm::dot(from, axis)}, exact::kTau * 0.042};
}

ChartPoint legPoint(const dvec3& p, const Anatomy& a) {
  const bool thigh = p.y > a.knee.y;
  const dvec3 &top = thigh ? a.hip : a.knee, &bottom = thigh ? a.knee : a.ankle;
  const dvec3 axis = glm::mix(bottom, top, glm::clamp((p.y - bottom.y) / (top.y - bottom.y), 0.0, 1.0));
  return {{turns(p.z - axis.z, -(p.x - axis.x)), p.y}, exact::kTau * 0.062};
}

ChartPoint handPoint(const dvec3& p, const Anatomy& a) {
  return {{glm::dot(p - a.wrist, a.across), glm::dot(p - a.wrist, a.along)}};
}

/// Seen from above; what stands upright at the rim is spread outwards.
ChartPoint instepPoint(const dvec3& p) {
  const dvec2 middle(0.112, 0.03);
  return {middle + (dvec2(p.x, p.z) - middle) * (1.0 + 6.0 * (0.08 - p.y))};
}

/// `p` on the left half, or a right half mirrored to the left.
ChartPoint chartPoint(Region region, const dvec3& p) {
  const Anatomy& a = anatomy();
  switch (region) {
    case kFace:
      return headPoint(p, 1.0);
    case kSkull:
      return headPoint(p, -1.0);
    case kThroat:
      return throatPoint(p);
    case kFront:
      return trunkPoint(p, 1.0);
    case kBack:
      return trunkPoint(p, -1.0);
    case kArm:
      return armPoint(p, a);
    case kPalm:
    case kHandBack:
      return handPoint(p, a);
    case kLeg:
      return legPoint(p, a);
    case kInstep:
      return instepPoint(p);
    default:
      return {{p.x, p.z}};
  }
}

/// Softened copies of the normals, so that charts have simple borders.
std::vector<dvec3> smoothNormals(const ClosedMesh& mesh, uint32_t rounds) {
  const uint32_t count = static_cast<uint32_t>(mesh.positions.size());
  const Neighbours neighbours = neighboursOf(count, mesh.triangles);
  std::vector<dvec3> normals = mesh.normals;
  for (uint32_t round = 0; round < rounds; ++round) {
    const std::vector<dvec3> before = normals;
    for (uint32_t v = 0; v < count; ++v) {
      const double share = 1.0 / (neighbours.first[v + 1] - neighbours.first[v] + 1);
      normals[v] *= share;
      for (uint32_t i = neighbours.first[v]; i < neighbours.first[v + 1]; ++i) {
        normals[v] += share * before[neighbours.list[i]];
      }
    }
  }
  return normals;
}

/// Which limb a joint belongs to, before it is told front from back.
Region limbOf(uint32_t joint) {
  if (joint == kHead) return kFace;
  if (joint == kNeck) return kThroat;
  if (joint < kMiddleJoints) return kFront;
  const uint32_t side_joint = (joint - kMiddleJoints) % kSideJoints;
  if (side_joint == kClavicle) return kFront;
  if (side_joint <= kForearm) return kArm;
  if (side_joint < kThigh) return kPalm;
  return side_joint <= kShin ? kLeg : kInstep;
}

class Tailor {
 public:
  Tailor(SurfaceBuilder& surface, const ClosedMesh& mesh, const Binding& binding)
      : surface_(surface), mesh_(mesh), binding_(binding), normals_(smoothNormals(mesh, 6)) {}

  void run(const std::vector<PartIndex>& parts) {
    for (const auto& triangle : mesh_.triangles) corners_.push_back(unroll(triangle));
    packAll();
    for (size_t t = 0; t < mesh_.triangles.size(); ++t) sew(parts[t], mesh_.triangles[t], corners_[t]);
  }

 private:
  struct Corners {
    uint32_t chart = 0;
    std::array<bool, 3> continued{};  ///< past the cut of an unrolled chart
    std::array<dvec2, 3> uv{};        ///< metres
  };

  Region regionOf(const std::array<uint32_t, 3>& triangle, const dvec3& middle) const {
    std::array<Region, 3> votes;
    for (int k = 0; k < 3; ++k) votes[k] = limbOf(binding_.nearest_joint[triangle[k]]);
    const Region limb = votes[1] == votes[2] ? votes[1] : votes[0];
    const dvec3 normal = normals_[triangle[0]] + normals_[triangle[1]] + normals_[triangle[2]];
    switch (limb) {
      case kFace:
        return middle.z > -0.035 ? kFace : kSkull;
      case kFront:
        return middle.z > -0.015 ? kFront : kBack;
      case kPalm: {
        const dvec3 palm = anatomy().palm;
        return glm::dot(normal, middle.x < 0.0 ? mirror(palm) : palm) > 0.0 ? kPalm : kHandBack;
      }
      case kInstep:
        return normal.y < -0.75 * lengthOf(normal) ? kSole : kInstep;
      default:
        return limb;
    }
  }

  Corners unroll(const std::array<uint32_t, 3>& triangle) const {
    const auto& p = mesh_.positions;
    const dvec3 middle = (p[triangle[0]] + p[triangle[1]] + p[triangle[2]]) / 3.0;
    const Region region = regionOf(triangle, middle);
    const bool paired = region >= kArm, right = paired && middle.x < 0.0;
    Corners corners;
    corners.chart = chartOf(region, right);
    std::array<ChartPoint, 3> points;
    double highest = 0.0;
    for (int k = 0; k < 3; ++k) {
      points[k] = chartPoint(region, right ? mirror(p[triangle[k]]) : p[triangle[k]]);
      highest = std::max(highest, points[k].uv.x);
    }
    for (int k = 0; k < 3; ++k) {
      corners.uv[k] = points[k].uv;
      if (points[k].metres_per_turn == 0.0) continue;
      corners.continued[k] = points[k].uv.x < highest - 0.5;
      corners.uv[k].x = (points[k].uv.x + (corners.continued[k] ? 1.0 : 0.0)) * points[k].metres_per_turn;
    }
    return corners;
  }

  void packAll() {
    const dvec2 far(1e30);
    low_.assign(2 * kRegions, far);
    std::vector<dvec2> high(2 * kRegions, -far), size(2 * kRegions, dvec2(0.0));
    for (const Corners& corners : corners_) {
      for (const dvec2& uv : corners.uv) {
        low_[corners.chart] = glm::min(low_[corners.chart], uv);
        high[corners.chart] = glm::max(high[corners.chart], uv);
      }
    }
    for (uint32_t chart = 0; chart < 2 * kRegions; ++chart) {
      if (low_[chart].x < far.x) size[chart] = high[chart] - low_[chart];
    }
    packing_ = packCharts(size, 0.004);
  }

  void sew(PartIndex part, const std::array<uint32_t, 3>& triangle, const Corners& corners) {
    std::array<uint32_t, 3> wedges;
    for (int k = 0; k < 3; ++k) wedges[k] = wedge(part, triangle[k], corners, k);
    surface_.addTriangle(part, wedges);
  }

  uint32_t wedge(PartIndex part, uint32_t vertex, const Corners& corners, int k) {
    const uint64_t place = (uint64_t{part} * 2 * kRegions + corners.chart) * 2 + (corners.continued[k] ? 1 : 0);
    const auto [entry, is_new] = wedges_.try_emplace(place << 32 | vertex, 0);
    if (is_new) {
      SurfacePoint point{mesh_.positions[vertex], mesh_.normals[vertex], {}, binding_.skins[vertex]};
      point.uv = packing_.corner[corners.chart] + (corners.uv[k] - low_[corners.chart]) * packing_.scale;
      entry->second = surface_.addVertex(part, point);
    }
    return entry->second;
  }

  SurfaceBuilder& surface_;
  const ClosedMesh& mesh_;
  const Binding& binding_;
  const std::vector<dvec3> normals_;
  std::vector<Corners> corners_;
  std::vector<dvec2> low_;  ///< per chart, the low corner of its box in metres
  Packing packing_;
  std::unordered_map<uint64_t, uint32_t> wedges_;  ///< only looked up, never walked through
};

}  // namespace

void addBody(SurfaceBuilder& surface, const ClosedMesh& mesh, const std::vector<PartIndex>& parts,
             const Binding& binding) {
  Tailor(surface, mesh, binding).run(parts);
}

}  // namespace lithe::bake::figure
