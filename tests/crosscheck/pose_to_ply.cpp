// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// One instant of a character as a mesh that other tools read.
//
//     pose_to_ply FILE.glb CLIP SECONDS UNIT OUT.ply      CLIP - is the rest pose; positions are divided by UNIT
#include <cstdio>
#include <cstdlib>
#include <string>

#include "lithe/bake/import.h"
#include "lithe/bake/poses.h"

namespace {

using lithe::bake::Model;
using lithe::bake::Pose;

Pose poseAt(const Model& model, const std::string& clip, double seconds) {
  if (clip == "-") return lithe::bake::restPose(model);
  for (uint32_t i = 0; i < model.clips.size(); ++i)
    if (model.clips[i].name == clip) return lithe::bake::clipPose(model, i, seconds);
  throw lithe::bake::Error("there is no clip '" + clip + "'");
}

void writePly(const Model& model, const std::vector<glm::dvec3>& positions, double unit, const char* path) {
  std::FILE* file = std::fopen(path, "w");
  if (!file) throw lithe::bake::Error(std::string(path) + ": cannot be written");
  std::fprintf(file, "ply\nformat ascii 1.0\nelement vertex %zu\n", positions.size());
  for (const char axis : {'x', 'y', 'z'}) std::fprintf(file, "property float %c\n", axis);
  std::fprintf(file, "element face %zu\nproperty list uchar int vertex_indices\nend_header\n", model.triangles.size());
  for (const glm::dvec3& p : positions) std::fprintf(file, "%.9g %.9g %.9g\n", p.x / unit, p.y / unit, p.z / unit);
  for (const auto& t : model.triangles) std::fprintf(file, "3 %u %u %u\n", t[0], t[1], t[2]);
  if (std::fclose(file) != 0) throw lithe::bake::Error(std::string(path) + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 6) {
    std::fprintf(stderr, "use pose_to_ply FILE.glb CLIP SECONDS UNIT OUT.ply\n");
    return 2;
  }
  const Model model = lithe::bake::importGltf(argv[1]);
  writePly(model, lithe::bake::skinPositions(model, poseAt(model, argv[2], std::atof(argv[3]))), std::atof(argv[4]),
           argv[5]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "pose_to_ply: %s\n", error.what());
  return 1;
}
