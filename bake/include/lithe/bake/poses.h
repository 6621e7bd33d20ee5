// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Posing a character: the rest pose, instants of its clips, sampled poses, and the choice of example poses for a bake.
///
/// All functions are pure: same arguments, same result on every machine. Palettes are computed in double precision and
/// then rounded to the precision a float would give the largest entry of the linear part and of the translation, so
/// that the last bit in which one libm's sin or acos differs from another's does not reach the result. Safe to call
/// from several threads at once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "lithe/bake/model.h"

namespace lithe::bake {

/// Largest rotation of a joint in a sampled pose, in degrees, about a random axis.
inline constexpr double kSampledDegrees = 40.0;
/// Part of kSampledDegrees that joints without a parent joint get: turning the whole character says little about its
/// skin.
inline constexpr double kSampledRootShare = 0.2;
/// Candidate poses are taken from clips at this rate (per second) as long as kMaxCandidates allows, but at least one
/// per clip.
inline constexpr double kCandidateRate = 30.0;
inline constexpr uint32_t kMaxCandidates = 384;

/// The pose without animation.
Pose restPose(const Model& model);

/// The pose of one clip at `time` (seconds; times outside the clip hold its first or last keys).
/// Rotations of linear channels are interpolated spherically along the shorter arc, cubic splines as glTF 2.0 says
/// (appendix C), nodes without a channel stay at rest. Several channels for one property: the last one counts.
/// @throws Error if there is no such clip
Pose clipPose(const Model& model, uint32_t clip, double time);

/// The pose given by one local transform per node (parallel to Model::nodes; rotations need not be normalised).
/// @throws Error if the number of transforms is not the number of nodes
Pose localPose(const Model& model, std::span<const Transform> locals);

/// Poses number `first` to first + count - 1 of an endless row in which every joint is turned from rest about a random
/// axis by up to kSampledDegrees. Pose i is scaled by 1, 1/2, 3/4 or 1/4 in turn, so that strong and mild poses occur
/// in any stretch of it.
std::vector<Pose> sampledPoses(const Model& model, uint32_t count, uint32_t first = 0);

struct PoseOptions {
  uint32_t count = 16;             ///< poses wanted, at least 1
  std::vector<std::string> clips;  ///< names of the clips to take poses from; empty: all
  std::filesystem::path file;      ///< a pose file (see readPoseFile); when given, exactly its poses are used
};

/// The example poses of a bake.
///
/// With clips: candidates are sampled from them at kCandidateRate and at the keys of clips with few keys, and `count`
/// of them are chosen by greedy k-centre (T. Gonzalez, Clustering to minimize the maximum intercluster distance, 1985):
/// first the candidate farthest from the rest pose, then again and again the one farthest from all chosen. The distance
/// is the root mean square over a fixed subset of the posed vertices after their centroid is removed. Fewer distinct
/// candidates than `count`: the distinct ones. Without clips: the rest pose and count - 1 sampled poses.
/// @return in the order of choice, at least one pose
/// @throws Error if a named clip does not exist, if `count` is 0, or as readPoseFile()
std::vector<Pose> choosePoses(const Model& model, const PoseOptions& options);

/// Reads poses from a JSON file:
///
///     {"poses": [{"nodes": {"Hips": {"translation": [0, 0.9, 0], "rotation": [0, 0, 0.38, 0.92], "scale": [1, 1,
///     1]}}}]}
///
/// Node names are the model's; a property replaces the node's rest value (local, metres or whatever the file's unit is;
/// rotations are quaternions x y z w and are normalised). What is not named stays at rest.
/// @throws Error naming the file and the pose if it cannot be read, is not of this shape, or names a node that the
/// model
///         lacks or has more than once
std::vector<Pose> readPoseFile(const Model& model, const std::filesystem::path& path);

/// The posed position of every vertex: sum over influences of weight * palette[joint] * position.
/// @param pose  a palette with one matrix per joint of the model
std::vector<glm::dvec3> skinPositions(const Model& model, const Pose& pose);

/// The mean over poses of the diagonal of the posed vertices' bounding box; 0 without poses or vertices.
double posedDiagonal(const Model& model, const std::vector<Pose>& poses);

}  // namespace lithe::bake
