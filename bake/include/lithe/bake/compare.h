// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// How far a simplified character is from its original while both move: the measure every figure of lithe is stated in.
///
/// Both models are posed by the ORIGINAL's nodes, each with its own inverse binds and renormalised weights. A joint of
/// the simplified model follows the original's node of the same name; where names do not decide, the joint of the same
/// index. In every frame both posed surfaces are sampled afresh, by area, and every sample's exact distance to the
/// other surface is taken (Metro: Cignoni, Rocchini and Scopigno, "Metro: measuring error on simplified surfaces",
/// 1998).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

/// Where in a clip its frames lie: `kMid` in the middle of equal slices, `kEnds` evenly from the first to the last key,
/// `kBetween` as `kMid` but each moved halfway between two of the instants that a bake chooses its example poses from
/// (kCandidateRate): as far from what the bake has seen as a frame of the clip can be.
enum class FramePhase : uint8_t { kMid, kEnds, kBetween };

struct CompareOptions {
  /// `all` clips, one clip's name (or its index as a number), `sampled` poses, or `none` for the rest pose alone.
  /// A model without clips is compared in sampled poses where `all` is asked for.
  std::string animation = "all";
  /// Frames in total, spread over the chosen clips by duration, one per clip at least; with fewer frames than clips,
  /// that many clips give one each. 0: every chosen clip at 30 frames a second, ends included. At most 100,000.
  uint32_t frames = 10;
  FramePhase phase = FramePhase::kMid;
  uint32_t first_pose = 0;     ///< number of the first sampled pose; a bake without clips takes its own from 0 on
  uint32_t samples = 20000;    ///< per frame and direction [limit: 1..10,000,000]
  uint32_t threads = 0;        ///< 0: one per core; the report does not depend on it
  uint64_t seed = 1;           ///< of the samples
  bool include_rigid = false;  ///< measure rigid parts too, not only skinned ones
  /// A distance in model units: the share of samples that are farther than it is measured too.
  std::optional<double> beyond;
};

/// One direction: from the samples of one surface to the nearest points of the other. Lengths are divided by the
/// original's rest diagonal. Where several points are equally near (an edge, coincident layers), the one that agrees
/// best is matched.
struct SurfaceError {
  double rms = 0.0;
  double mean = 0.0;
  double max = 0.0;             ///< Hausdorff distance over samples and vertices
  double p999 = 0.0;            ///< 99.9th percentile of the samples
  double normal_degrees = 0.0;  ///< RMS angle between the interpolated vertex normals
  double flipped = 0.0;         ///< share of the area whose face normal is more than 90 degrees from the matched face's
  double uv_rms = 0.0;          ///< of |uv - uv'|, uv set 0; zero unless both models have it
  double uv_median = 0.0;
  /// How much a texture is stretched or squeezed beyond what it is on the original, in the direction that is worst off:
  /// the mean of ln max(Gamma, 1 / gamma), Gamma >= gamma the singular values of the map from the original's posed
  /// triangle to the simplified model's through the texture, uv set 0. After Sander, Snyder, Gortler and Hoppe,
  /// "Texture mapping progressive meshes" (2001). 0 for none, near it the relative stretch (0.1 is ten percent), at
  /// most ln 16: that much also counts where the texture is mirrored, or where the simplified model's triangle has no
  /// area on the surface or on the texture. A sample where the original's has none, or that of an equally near point,
  /// says nothing and is in no mean. Zero where none says anything.
  double uv_stretch = 0.0;
  double beyond = 0.0;  ///< share of the samples that are farther than CompareOptions::beyond; zero without it
};

/// Seams are places where several vertices of the simplified model coincide in the rest pose.
/// Lengths are divided by the original's rest diagonal.
struct SeamError {
  double gap = 0.0;  ///< the widest that the vertices of one seam place move apart
  double opened =
      0.0;  ///< the same less what the original opens at that place: above rounding, it is a crack that was made
};

struct FrameReport {
  std::string clip;   ///< empty: a sampled pose or the rest pose
  double time = 0.0;  ///< seconds
  SurfaceError original_to_simplified;
  SurfaceError simplified_to_original;
  SurfaceError symmetric;  ///< member by member the larger of the two
  /// The area that one of the two surfaces covers and the other does not, over the area that the original covers, seen
  /// orthographically and summed over six directions; zero or more, 0.01 is one percent of the silhouette. After
  /// Lindstrom and Turk, "Image-driven simplification" (2000), with masks for pictures. The directions are the axes
  /// through the vertices of an icosahedron; a mask has 512 pixels along the diagonal of the posed original's box.
  double silhouette = 0.0;
  SeamError seam;
};

struct CompareReport {
  uint32_t original_triangles = 0;
  uint32_t original_vertices = 0;  ///< those that a measured triangle uses
  uint32_t simplified_triangles = 0;
  uint32_t simplified_vertices = 0;
  double rest_diagonal = 0.0;  ///< multiply lengths by it for model units
  bool has_uv = false;         ///< uv deviations were measured
  uint32_t samples = 0;
  std::optional<double> beyond;  ///< the option
  std::vector<FrameReport> frames;
  SurfaceError mean;              ///< of the frames' symmetric figures; mean.rms is the headline
  SurfaceError worst;             ///< the largest of the frames' symmetric figures
  double mean_silhouette = 0.0;   ///< of the frames
  double worst_silhouette = 0.0;  ///< the largest of the frames
  SeamError seam;                 ///< the largest of the frames
  double weight_sum_error = 0.0;  ///< largest |1 - sum of weights| of a simplified vertex, as imported
};

/// Measures `simplified` against `original`. Deterministic: the same arguments give the same report for any thread
/// count. Throws Error when one of them has no (skinned) triangle, a joint finds no node in the original, a clip is
/// unknown, or an option is out of its limits. Keeps no state; several calls may run at once.
CompareReport compare(const Model& original, const Model& simplified, const CompareOptions& options);

/// The report as a table for people, ending in a newline.
std::string compareText(const CompareReport& report);

/// The report as JSON: the same figures, plus every frame. Lengths as fractions of the rest diagonal; keys that end in
/// `_absolute` in model units.
std::string compareJson(const CompareReport& report);

}  // namespace lithe::bake
