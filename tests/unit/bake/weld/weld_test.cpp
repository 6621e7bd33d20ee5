// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/weld.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lithe/format/octahedral.h"

namespace lithe::bake {
namespace {

Skin skinOf(std::initializer_list<std::pair<uint16_t, float>> influences) {
  Skin skin;
  for (const auto& [joint, weight] : influences) {
    skin.joint[skin.count] = joint;
    skin.weight[skin.count++] = weight;
  }
  return skin;
}

/// Adds a triangle of its own three vertices, the way an unindexed file does.
void addTriangle(Model& model, uint32_t part, const std::array<glm::vec3, 3>& corners,
                 const std::array<Skin, 3>& skins) {
  const auto first = static_cast<uint32_t>(model.positions.size());
  for (uint32_t k = 0; k < 3; ++k) {
    model.positions.push_back(corners[k]);
    model.skins.push_back(skins[k]);
  }
  model.triangles.push_back({first, first + 1, first + 2});
  model.triangle_part.push_back(part);
}

Model modelWithParts(uint32_t parts) {
  Model model;
  model.parts.resize(parts);
  model.joints.resize(8);
  return model;
}

/// Two triangles of a unit square with six corners of their own.
Model unindexedSquare() {
  Model model = modelWithParts(1);
  const Skin s = skinOf({{0, 1.0f}});
  addTriangle(model, 0, {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(1, 1, 0)}, {s, s, s});
  addTriangle(model, 0, {glm::vec3(0, 0, 0), glm::vec3(1, 1, 0), glm::vec3(0, 1, 0)}, {s, s, s});
  return model;
}

Mesh weldQuietly(const Model& model, const WeldOptions& options = {}, const std::vector<Pose>& poses = {}) {
  std::vector<std::string> warnings;
  return weld(model, poses, options, warnings);
}

TEST(Weld, JoinsCornersThatCoincide) {
  const Mesh mesh = weldQuietly(unindexedSquare());
  EXPECT_EQ(mesh.vertexCount(), 4u);
  EXPECT_EQ(mesh.wedgeCount(), 4u);
  ASSERT_EQ(mesh.triangleCount(), 2u);
  EXPECT_EQ(mesh.positions[mesh.corner(0, 2)], glm::ivec3(16383, 16383, 0));
}

TEST(Weld, JoinsAcrossCellBordersWithinTheToleranceOnly) {
  Model model = unindexedSquare();
  const float tolerance = static_cast<float>(1e-6 * std::sqrt(2.0));
  model.positions[3].x -= 0.7f * tolerance;  // the box's corner moves with it: now just below the old lower corner
  EXPECT_EQ(weldQuietly(model).vertexCount(), 4u);
  model.positions[3].x -= 2.0f * tolerance;
  EXPECT_EQ(weldQuietly(model).vertexCount(), 5u);
}

TEST(Weld, KeepsVerticesOfOtherWeightsApartOnOneGridPoint) {
  Model model = unindexedSquare();
  model.skins[3] = skinOf({{0, 0.98f}, {1, 0.02f}});  // L1 difference .04
  const Mesh mesh = weldQuietly(model);
  EXPECT_EQ(mesh.vertexCount(), 5u);
  model.skins[3] = skinOf({{0, 0.995f}, {1, 0.005f}});  // .01: the first vertex's skin wins
  const Mesh near = weldQuietly(model);
  EXPECT_EQ(near.vertexCount(), 4u);
  EXPECT_EQ(near.skins[near.corner(0, 0)].count, 1);
}

TEST(Weld, NeverJoinsDifferentRigidNodesOrRigidAndSkinned) {
  Model model = unindexedSquare();
  model.parts.resize(2);
  model.triangle_part[1] = 1;
  EXPECT_EQ(weldQuietly(model).vertexCount(), 4u);
  model.parts[1].rigid_node = 3;
  const Mesh mixed = weldQuietly(model);
  EXPECT_EQ(mixed.vertexCount(), 6u);
  EXPECT_FALSE(mixed.rigid_vertex[mixed.corner(0, 0)]);
  EXPECT_TRUE(mixed.rigid_vertex[mixed.corner(1, 0)]);
  model.parts[0].rigid_node = 2;
  EXPECT_EQ(weldQuietly(model).vertexCount(), 6u);
  model.parts[0].rigid_node = 3;
  EXPECT_EQ(weldQuietly(model).vertexCount(), 4u);
}

TEST(Weld, GivesEachPartItsOwnWedges) {
  Model model = unindexedSquare();
  model.parts.resize(2);
  model.triangle_part[1] = 1;
  const Mesh mesh = weldQuietly(model);
  EXPECT_EQ(mesh.vertexCount(), 4u);
  EXPECT_EQ(mesh.wedgeCount(), 6u);
}

TEST(Weld, DropsDegenerateAndRepeatedTrianglesAndSaysSo) {
  Model model = unindexedSquare();
  model.triangles.push_back({0, 1, 0});
  model.triangles.push_back({4, 5, 3});  // the second one, rotated
  model.triangles.push_back({5, 4, 3});  // turned over: a two-sided sheet stays
  model.triangle_part.insert(model.triangle_part.end(), {0, 0, 0});
  std::vector<std::string> warnings;
  const Mesh mesh = weld(model, {}, {}, warnings);
  EXPECT_EQ(mesh.triangleCount(), 3u);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_NE(warnings[0].find("1 triangles dropped because two"), std::string::npos);
  EXPECT_NE(warnings[1].find("1 triangles dropped because they repeat"), std::string::npos);
}

TEST(Weld, QuantisesTexturesPerPart) {
  Model model = unindexedSquare();
  model.parts.resize(2);
  model.triangle_part[1] = 1;
  model.attributes.uv_sets = 1;
  model.uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {-8, 2}, {8, 2}, {8, 10}};
  const Mesh mesh = weldQuietly(model);
  for (uint32_t t = 0; t < 2; ++t) {
    for (uint32_t k = 0; k < 3; ++k) {
      const UvGrid& grid = mesh.part_uv[t][0];
      const glm::dvec2 uv = grid.offset + grid.scale * glm::dvec2(mesh.wedge_uv[0][mesh.triangles[t][k]]);
      const glm::dvec2 source(model.uvs[0][model.triangles[t][k]]);
      EXPECT_LE(glm::distance(uv, source), grid.scale);
    }
  }
  EXPECT_DOUBLE_EQ(mesh.part_uv[0][0].scale, 1.0 / 4095);
  EXPECT_DOUBLE_EQ(mesh.part_uv[1][0].scale, 16.0 / 4095);
}

TEST(Weld, QuantisesNormalsToTheNearestOctahedralPoint) {
  Model model = modelWithParts(1);
  model.attributes.normal = true;
  const Skin s = skinOf({{0, 1.0f}});
  for (int i = 0; i < 40; ++i) {
    const auto x = static_cast<float>(i);
    addTriangle(model, 0, {glm::vec3(x, 0, 0), glm::vec3(x + 1, 0, 0), glm::vec3(x, 1, 0)}, {s, s, s});
    for (int k = 0; k < 3; ++k) {
      const double a = 0.37 * (3 * i + k), z = std::cos(1.7 * (3 * i + k));
      const double r = std::sqrt(1.0 - z * z);
      model.normals.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
  }
  WeldOptions options;
  options.normal_bits = 8;
  const Mesh mesh = weldQuietly(model, options);
  const int32_t center = format::octahedralCenter(8);
  const auto cosine = [&](glm::ivec2 point, const glm::vec3& normal) {
    int32_t d[3];
    format::octahedralDirection({point.x, point.y}, center, d);
    return glm::dot(glm::normalize(glm::dvec3(d[0], d[1], d[2])), glm::normalize(glm::dvec3(normal)));
  };
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (uint32_t k = 0; k < 3; ++k) {
      const glm::vec3 normal = model.normals[model.triangles[t][k]];
      double best = -1.0;
      for (int32_t y = 0; y <= 2 * center; ++y) {
        for (int32_t x = 0; x <= 2 * center; ++x) best = std::max(best, cosine({x, y}, normal));
      }
      EXPECT_NEAR(std::acos(std::min(1.0, cosine(mesh.wedge_normal[mesh.triangles[t][k]], normal))),
                  std::acos(std::min(1.0, best)), 1e-7);
    }
  }
}

TEST(Weld, CapsInfluencesAndRefitsThemToThePoses) {
  Model model = unindexedSquare();
  // Joint 4 moves as joint 0 does, so the refit must give its weight to joint 0; without it the shares would be scaled.
  for (Skin& skin : model.skins) skin = skinOf({{0, 0.3f}, {1, 0.25f}, {2, 0.2f}, {3, 0.15f}, {4, 0.1f}});
  std::vector<Pose> poses;
  for (int p = 0; p < 6; ++p) {
    Pose pose;
    for (int j = 0; j < 8; ++j) {
      glm::dmat4 matrix(1.0);
      const int motion = j == 4 ? 0 : j;
      matrix[3] =
          glm::dvec4(std::sin(p + 2.0 * motion), std::cos(3.0 * p * (motion + 1)), p == motion ? 3.0 : 0.0, 1.0);
      pose.palette.push_back(matrix);
    }
    poses.push_back(pose);
  }
  std::vector<std::string> warnings;
  const Mesh mesh = weld(model, poses, {}, warnings);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("4 vertices had more than 4 influences"), std::string::npos);
  const QuantizedSkin& skin = mesh.skins[0];
  ASSERT_EQ(skin.count, 4);
  EXPECT_EQ(skin.joint[0], 0);
  EXPECT_EQ(skin.weight[0], 102);  // .4 of 255
  EXPECT_EQ(skin.weight[0] + skin.weight[1] + skin.weight[2] + skin.weight[3], 255);
}

TEST(Weld, KeepsTheInfluencesThatMoveTheVertexNotTheLargest) {
  Model model = unindexedSquare();
  // Joint 1 moves as joint 0 does: joints 0 and 2 say all, three quarters and a quarter; the two largest cannot.
  for (Skin& skin : model.skins) skin = skinOf({{0, 0.4f}, {1, 0.35f}, {2, 0.25f}});
  std::vector<Pose> poses(3);
  for (size_t p = 0; p < poses.size(); ++p) {
    poses[p].palette.assign(8, glm::dmat4(1.0));
    poses[p].palette[2][3] = glm::dvec4(1.0 + p, 2.0 * p, 0.0, 1.0);
  }
  WeldOptions options;
  options.max_influences = 2;
  std::vector<std::string> warnings;
  const QuantizedSkin skin = weld(model, poses, options, warnings).skins[0];
  ASSERT_EQ(skin.count, 2);
  EXPECT_EQ(skin.joint[0], 0);
  EXPECT_EQ(skin.joint[1], 2);
  EXPECT_EQ(skin.weight[0], 191);  // .75 of 255
  EXPECT_EQ(skin.weight[1], 64);
}

TEST(Weld, RefusesOptionsOutOfTheirLimitsAndEmptyMeshes) {
  WeldOptions options;
  options.max_influences = 9;
  EXPECT_THROW(weldQuietly(unindexedSquare(), options), Error);
  options = {};
  options.position_bits = 40;
  EXPECT_THROW(weldQuietly(unindexedSquare(), options), Error);
  EXPECT_THROW(weldQuietly(modelWithParts(1)), Error);
  Model flat = unindexedSquare();
  for (glm::vec3& position : flat.positions) position = glm::vec3(1.0f);
  EXPECT_THROW(weldQuietly(flat), Error);
}

TEST(Weld, KeepsOnlyTheAttributesAskedFor) {
  Model model = unindexedSquare();
  model.attributes = {true, false, 2, 0};
  model.normals.assign(6, {0, 0, 1});
  model.uvs[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  model.uvs[1] = {{0, 0}, {1, 0}, {1, 1}, {0.5f, 0}, {1, 0.5f}, {0, 1}};  // a seam in the second set only
  EXPECT_EQ(weldQuietly(model).wedgeCount(), 6u);
  WeldOptions options;
  options.attributes = {true, true, 1, 2};
  const Mesh mesh = weldQuietly(model, options);
  EXPECT_EQ(mesh.wedgeCount(), 4u);
  EXPECT_EQ(mesh.attributes.uv_sets, 1u);
  EXPECT_FALSE(mesh.attributes.tangent);
  EXPECT_TRUE(mesh.wedge_tangent.empty());
}

}  // namespace
}  // namespace lithe::bake
