// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "surface_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "surface_distance.h"
#include "uv_stretch.h"

namespace lithe::bake {

namespace {

constexpr double kTie = 1e-7;  // of the posed diagonal: points this much further away count as equally near

glm::dvec3 faceNormal(const SearchableSurface& s, uint32_t triangle) {
  const Triangle& t = s.surface.triangles[triangle];
  const glm::dvec3 origin = s.posed.positions[t[0]];
  return glm::cross(s.posed.positions[t[1]] - origin, s.posed.positions[t[2]] - origin);
}

template <typename Vector>
Vector interpolated(const std::vector<Vector>& values, const Triangle& t, const glm::dvec3& barycentric) {
  return values[t[0]] * barycentric.x + values[t[1]] * barycentric.y + values[t[2]] * barycentric.z;
}

/// atan2 of cross and dot: exact for small angles, where acos is not. Vectors without direction agree with everything.
double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

TexturedTriangle texturedTriangle(const SearchableSurface& s, uint32_t triangle) {
  const Triangle& t = s.surface.triangles[triangle];
  return {{s.posed.positions[t[0]], s.posed.positions[t[1]], s.posed.positions[t[2]]},
          {s.surface.uvs[t[0]], s.surface.uvs[t[1]], s.surface.uvs[t[2]]}};
}

/// The least of the matches. Nothing where any of them says nothing: of equally near points none agrees better than one
/// at which the original has no texture.
std::optional<double> leastUvStretch(const SearchableSurface& from, uint32_t source, const SearchableSurface& to,
                                     const std::vector<NearestPoint>& matches, bool from_original) {
  const TexturedTriangle own = texturedTriangle(from, source);
  double least = kMostUvStretch;
  for (const NearestPoint& match : matches) {
    const TexturedTriangle other = texturedTriangle(to, match.triangle);
    const std::optional<double> stretch = from_original ? uvStretch(own, other) : uvStretch(other, own);
    if (!stretch) return std::nullopt;
    least = std::min(least, *stretch);
  }
  return least;
}

/// What one sample adds to the figures.
struct SampleError {
  double distance = 0.0;
  double angle = std::numeric_limits<double>::infinity();  ///< radians
  double uv = std::numeric_limits<double>::infinity();
  std::optional<double> uv_stretch;
  bool flipped = true;
};

/// The best agreement among the equally near points: which side of an edge or layer a sample met is no error of the
/// surface.
SampleError matchSample(const SearchableSurface& from, const SurfaceSample& sample, const SearchableSurface& to,
                        const std::vector<NearestPoint>& matches, const Sampling& sampling) {
  const Triangle& source = from.surface.triangles[sample.triangle];
  const glm::dvec3 normal = interpolated(from.posed.normals, source, sample.barycentric);
  const glm::dvec3 face = faceNormal(from, sample.triangle);
  SampleError error;
  error.distance = std::sqrt(matches.front().distance2);
  for (const NearestPoint& match : matches) {
    const Triangle& target = to.surface.triangles[match.triangle];
    error.angle =
        std::min(error.angle, angleBetween(normal, interpolated(to.posed.normals, target, match.barycentric)));
    error.flipped = error.flipped && glm::dot(face, faceNormal(to, match.triangle)) < 0.0;
    if (!sampling.with_uv) continue;
    const glm::dvec2 uv = interpolated(from.surface.uvs, source, sample.barycentric);
    error.uv = std::min(error.uv, glm::distance(uv, interpolated(to.surface.uvs, target, match.barycentric)));
  }
  if (sampling.with_uv) error.uv_stretch = leastUvStretch(from, sample.triangle, to, matches, sampling.from_original);
  return error;
}

/// Zero of none.
double mean(const std::vector<double>& values) {
  if (values.empty()) return 0.0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double rootMeanSquare(const std::vector<double>& values) {
  double sum2 = 0.0;
  for (const double value : values) sum2 += value * value;
  return std::sqrt(sum2 / static_cast<double>(values.size()));
}

}  // namespace

SurfaceError surfaceError(const SearchableSurface& from, const SearchableSurface& to, const Sampling& sampling) {
  const double slack = kTie * diagonalOf(to.posed.positions);
  std::vector<double> distances, angles, uvs, log_uv_stretches;
  std::vector<NearestPoint> matches;
  uint32_t flipped = 0, beyond = 0;
  uint32_t hint = kNone;
  for (const SurfaceSample& sample :
       sampleSurface(from.posed.positions, from.surface.triangles, sampling.samples, sampling.seed)) {
    const Triangle& triangle = from.surface.triangles[sample.triangle];
    to.tree.nearestWithin(pointOf(from.posed.positions, triangle, sample.barycentric), slack, matches, hint);
    hint = matches.front().triangle;
    const SampleError error = matchSample(from, sample, to, matches, sampling);
    distances.push_back(error.distance);
    angles.push_back(error.angle);
    if (sampling.with_uv) uvs.push_back(error.uv);
    if (error.uv_stretch) log_uv_stretches.push_back(std::log(*error.uv_stretch));
    flipped += error.flipped ? 1 : 0;
    beyond += error.distance > sampling.beyond ? 1 : 0;
  }
  const SurfaceDistance distance = summarizeDistances(distances);
  SurfaceError result{distance.rms, distance.mean, distance.max, distance.p999};
  result.max = farthestVertex(from.posed.positions, from.surface.triangles, to.tree, distance.max);
  result.normal_degrees = glm::degrees(rootMeanSquare(angles));
  result.flipped = static_cast<double>(flipped) / sampling.samples;
  result.beyond = static_cast<double>(beyond) / sampling.samples;
  if (sampling.with_uv) {
    result.uv_rms = rootMeanSquare(uvs);
    result.uv_median = percentile(uvs, 0.5);
    result.uv_stretch = mean(log_uv_stretches);
  }
  return result;
}

SurfaceError largerOf(const SurfaceError& a, const SurfaceError& b) {
  return {std::max(a.rms, b.rms),
          std::max(a.mean, b.mean),
          std::max(a.max, b.max),
          std::max(a.p999, b.p999),
          std::max(a.normal_degrees, b.normal_degrees),
          std::max(a.flipped, b.flipped),
          std::max(a.uv_rms, b.uv_rms),
          std::max(a.uv_median, b.uv_median),
          std::max(a.uv_stretch, b.uv_stretch),
          std::max(a.beyond, b.beyond)};
}

void accumulate(SurfaceError& sum, const SurfaceError& error) {
  sum.rms += error.rms;
  sum.mean += error.mean;
  sum.max += error.max;
  sum.p999 += error.p999;
  sum.normal_degrees += error.normal_degrees;
  sum.flipped += error.flipped;
  sum.uv_rms += error.uv_rms;
  sum.uv_median += error.uv_median;
  sum.uv_stretch += error.uv_stretch;
  sum.beyond += error.beyond;
}

SurfaceError scaled(const SurfaceError& error, double length_factor, double other_factor) {
  return {error.rms * length_factor,   error.mean * length_factor,          error.max * length_factor,
          error.p999 * length_factor,  error.normal_degrees * other_factor, error.flipped * other_factor,
          error.uv_rms * other_factor, error.uv_median * other_factor,      error.uv_stretch * other_factor,
          error.beyond * other_factor};
}

}  // namespace lithe::bake
