// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "nearest_face.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "meshes.h"
#include "random.h"

namespace lithe::bake {
namespace {

using namespace test;

/// A bent tube in so many poses, its surface, and what a search needs of it.
struct Scene {
  Mesh mesh;
  NodeState nodes;
  Surface surface;
  std::vector<EdgeLengths> lengths;

  explicit Scene(uint32_t pose_count) : mesh(weldQuietly(tube(10, 14))), nodes(nodesOf(pose_count)), surface(mesh) {
    for (uint32_t id = 0; id < surface.faceCount(); ++id) lengths.push_back(edgeLengths(surface.face(id), nodes.posed));
  }

  NodeState nodesOf(uint32_t pose_count) const {
    std::vector<std::vector<glm::dmat4>> palettes;
    for (const Pose& pose : bendingPoses(pose_count, 100.0, 2.0)) palettes.push_back(pose.palette);
    return {mesh.grid.bits, 4,          mesh.weight_one,         mesh.max_influences,
            mesh.positions, mesh.skins, poseMesh(mesh, palettes)};
  }

  /// Near a slot, by its own random amount in every pose.
  std::vector<PosedPoint> pointNear(uint32_t slot, lithe::test::Random& random) const {
    std::vector<PosedPoint> point(nodes.posed.at(slot), nodes.posed.at(slot) + nodes.posed.blocks);
    for (uint32_t pose = 0; pose < nodes.posed.pose_count; ++pose)
      for (Lanes* lanes : {&point[pose / kLanes].x, &point[pose / kLanes].y, &point[pose / kLanes].z})
        (*lanes)[pose % kLanes] += static_cast<float>(0.1 * random.unit() - 0.05);
    return point;
  }

  /// In all poses together.
  double squaredDistance(const std::vector<PosedPoint>& point, const Face& face,
                         const std::array<double, 3>& share) const {
    double sum = 0.0;
    for (uint32_t pose = 0; pose < nodes.posed.pose_count; ++pose) {
      const uint32_t block = pose / kLanes, lane = pose % kLanes;
      glm::dvec3 offset(point[block].x[lane], point[block].y[lane], point[block].z[lane]);
      for (uint32_t k = 0; k < 3; ++k) {
        const PosedPoint& corner = nodes.posed.at(face.corner[k])[block];
        offset -= share[k] * glm::dvec3(corner.x[lane], corner.y[lane], corner.z[lane]);
      }
      sum += glm::dot(offset, offset);
    }
    return sum;
  }

  /// The least over a fine net of points of every face at the slots.
  double leastOnNet(const std::vector<PosedPoint>& point, const std::array<uint32_t, 3>& slots) const {
    constexpr int kSteps = 24;
    double least = 1e300;
    for (uint32_t slot : slots)
      for (uint32_t id : surface.facesAt(slot))
        for (int i = 0; i <= kSteps; ++i)
          for (int j = 0; i + j <= kSteps; ++j) {
            const double v = double(i) / kSteps, w = double(j) / kSteps;
            least = std::min(least, squaredDistance(point, surface.face(id), {1.0 - v - w, v, w}));
          }
    return least;
  }
};

TEST(NearestFace, NoPointOfTheFacesAtTheSlotsIsNearer) {
  lithe::test::Random random(11);
  for (const uint32_t pose_count : {3u, 16u}) {
    const Scene scene(pose_count);
    FaceSearch search(scene.nodes, scene.surface, scene.lengths);
    for (int run = 0; run < 60; ++run) {
      const Face& face = scene.surface.face(random.below(scene.surface.faceCount()));
      std::array<uint32_t, 3> slots = face.corner;
      if (run % 3 == 1) slots[1] = slots[0];
      if (run % 3 == 2) slots = {slots[0], slots[0], slots[0]};
      const std::vector<PosedPoint> point = scene.pointNear(slots[0], random);
      const FacePoint found = search.nearest(point.data(), slots);
      ASSERT_NE(found.face, kNone);
      const Face& hit = scene.surface.face(found.face);
      EXPECT_TRUE(std::any_of(slots.begin(), slots.end(), [&](uint32_t slot) { return hit.has(slot); }));
      std::array<double, 3> share;
      for (uint32_t k = 0; k < 3; ++k) {
        share[k] = found.share[k];
        EXPECT_GE(share[k], -1e-6);
      }
      EXPECT_NEAR(share[0] + share[1] + share[2], 1.0, 1e-6);
      EXPECT_LE(scene.squaredDistance(point, hit, share), scene.leastOnNet(point, slots) * (1.0 + 1e-4) + 1e-9);
    }
  }
}

TEST(NearestFace, APointOfAFaceIsFoundWhereItLies) {
  const Scene scene(9);
  FaceSearch search(scene.nodes, scene.surface, scene.lengths);
  for (uint32_t id = 0; id < scene.surface.faceCount(); id += 7) {
    const Face& face = scene.surface.face(id);
    std::vector<PosedPoint> point(scene.nodes.posed.blocks);
    for (uint32_t block = 0; block < point.size(); ++block) {
      const PosedPoint &a = scene.nodes.posed.at(face.corner[0])[block],
                       &b = scene.nodes.posed.at(face.corner[1])[block],
                       &c = scene.nodes.posed.at(face.corner[2])[block];
      point[block] = {a.x * 0.5f + b.x * 0.3f + c.x * 0.2f, a.y * 0.5f + b.y * 0.3f + c.y * 0.2f,
                      a.z * 0.5f + b.z * 0.3f + c.z * 0.2f};
    }
    const FacePoint found = search.nearest(point.data(), face.corner);
    EXPECT_EQ(found.face, id);
    EXPECT_NEAR(found.share[0], 0.5f, 1e-3f);
    EXPECT_NEAR(found.share[1], 0.3f, 1e-3f);
  }
}

TEST(NearestFace, WithoutFacesThereIsNone) {
  Scene scene(2);
  std::vector<uint32_t> thirds;
  const Face& face = scene.surface.face(0);
  const uint32_t kept = face.corner[0], gone = face.corner[1];
  scene.surface.collapse(kept, gone, thirds);
  FaceSearch search(scene.nodes, scene.surface, scene.lengths);
  EXPECT_EQ(search.nearest(scene.nodes.posed.at(gone), {gone, gone, gone}).face, kNone);
  EXPECT_NE(search.nearest(scene.nodes.posed.at(gone), {gone, gone, kept}).face, kNone);
}

}  // namespace
}  // namespace lithe::bake
