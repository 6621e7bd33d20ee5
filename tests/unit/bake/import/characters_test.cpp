// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Real characters, where they are at hand.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "lithe/bake/import.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

std::filesystem::path modelPath(const std::string& file) {
  return std::filesystem::path(LITHE_SHARED_DIR) / "models" / file;
}

/// The triangles of skinned and of all parts, vertices, palette and clips.
struct Expected {
  const char* file;
  size_t skinned_triangles, triangles, vertices, joints, clips;
};

class ImportCharacter : public ::testing::TestWithParam<Expected> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(modelPath(GetParam().file))) GTEST_SKIP() << GetParam().file << " is not at hand";
  }
};

size_t skinnedTriangles(const Model& model) {
  size_t count = 0;
  for (const uint32_t part : model.triangle_part) count += model.parts[part].rigid_node == kNone ? 1 : 0;
  return count;
}

void expectValidArrays(const Model& model) {
  const size_t vertices = model.positions.size();
  ASSERT_EQ(model.skins.size(), vertices);
  ASSERT_EQ(model.normals.size(), vertices);
  ASSERT_EQ(model.tangents.size(), model.attributes.tangent ? vertices : 0);
  for (uint32_t set = 0; set < kMaxUvSets; ++set) {
    ASSERT_EQ(model.uvs[set].size(), set < model.attributes.uv_sets ? vertices : 0);
  }
  for (uint32_t set = 0; set < kMaxColorSets; ++set) {
    ASSERT_EQ(model.colors[set].size(), set < model.attributes.color_sets ? vertices : 0);
  }
  for (const glm::vec3& normal : model.normals) ASSERT_NEAR(glm::length(normal), 1.0f, 1e-5f);
  for (const glm::vec4& tangent : model.tangents) ASSERT_NEAR(glm::length(glm::vec3(tangent)), 1.0f, 1e-5f);
  for (const auto& triangle : model.triangles) {
    for (const uint32_t corner : triangle) ASSERT_LT(corner, vertices);
  }
}

void expectValidSkins(const Model& model) {
  for (const Skin& skin : model.skins) {
    float sum = 0.0f;
    for (uint32_t k = 0; k < skin.count; ++k) {
      ASSERT_LT(skin.joint[k], model.joints.size());
      ASSERT_GT(skin.weight[k], 0.0f);
      ASSERT_TRUE(k == 0 || skin.weight[k] <= skin.weight[k - 1]);
      sum += skin.weight[k];
    }
    ASSERT_NEAR(sum, 1.0f, 1e-5f);
  }
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    ASSERT_TRUE(model.nodes[i].parent == kNone || model.nodes[i].parent < i);
  }
}

TEST_P(ImportCharacter, HasTheExpectedSizeAndIsValid) {
  const Expected& expected = GetParam();
  const Model model = importGltf(modelPath(expected.file));
  EXPECT_EQ(model.triangles.size(), expected.triangles);
  EXPECT_EQ(skinnedTriangles(model), expected.skinned_triangles);
  EXPECT_EQ(model.positions.size(), expected.vertices);
  EXPECT_EQ(model.joints.size(), expected.joints);
  EXPECT_EQ(model.clips.size(), expected.clips);
  expectValidArrays(model);
  expectValidSkins(model);
}

/// One grid over all positions must not be wasted: bind space is no larger than what is seen, in its own unit.
TEST_P(ImportCharacter, BindSpaceIsAsCompactAsTheRestPose) {
  const Model model = importGltf(modelPath(GetParam().file));
  const Pose rest = restPose(model);
  glm::vec3 low = model.positions.front(), high = low;
  for (const glm::vec3& p : model.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  // The scale from bind to rest space, as the first vertex's heaviest joint has it.
  const glm::dmat3 linear(rest.palette[model.skins.front().joint[0]]);
  const double scale = std::cbrt(std::abs(glm::determinant(linear)));
  EXPECT_LT(glm::length(high - low) * scale, 2.0 * posedDiagonal(model, {rest}));
}

TEST_P(ImportCharacter, PosesAreChosenFromIt) {
  const Model model = importGltf(modelPath(GetParam().file));
  const std::vector<Pose> poses = choosePoses(model, {});
  EXPECT_GE(poses.size(), model.clips.empty() ? 16u : 1u);
  EXPECT_LE(poses.size(), 16u);
  const double diagonal = posedDiagonal(model, poses);
  EXPECT_TRUE(std::isfinite(diagonal));
  EXPECT_GT(diagonal, 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, ImportCharacter,
    ::testing::Values(Expected{"column.glb", 114688, 114688, 59334, 4, 2},
                      Expected{"sintel.glb", 41306, 41306, 25413, 66, 1},
                      Expected{"valid_asian_f3.glb", 61796, 61796, 33974, 99, 0},
                      Expected{"mannequiny.glb", 13932, 13932, 10366, 45, 10},
                      Expected{"pumpkin/scene.gltf", 18216, 18216, 11408, 56, 1},
                      Expected{"alien/Alien_Scolitex.gltf", 11036, 11036, 5764, 33, 1},
                      Expected{"bunny.gltf", 8284, 8284, 4545, 49, 14}, Expected{"shark.glb", 6576, 6576, 3514, 33, 7},
                      Expected{"knight.glb", 4148, 6952, 7024, 50, 76},
                      Expected{"dragon.glb", 3498, 3498, 2905, 100, 5}, Expected{"robot.glb", 3238, 3238, 7218, 43, 14},
                      Expected{"eight_influences.glb", 2112, 2112, 2439, 16, 1},
                      Expected{"spider.glb", 1600, 1600, 924, 56, 10}, Expected{"fox.glb", 576, 576, 1728, 24, 3}),
    [](const auto& expected) {
      std::string name = expected.param.file;
      for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
      return name;
    });

/// Skins are fuller than four influences where the file says so.
TEST(ImportCharacters, ReadsTheSecondSetOfJoints) {
  const std::filesystem::path path = modelPath("eight_influences.glb");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not at hand";
  uint8_t most = 0;
  for (const Skin& skin : importGltf(path).skins) most = std::max(most, skin.count);
  EXPECT_EQ(most, 6);
}

TEST(ImportCharacters, TakesEverySkinningCaseOfTheAssetGenerator) {
  const std::filesystem::path folder = modelPath("assetgen");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not at hand";
  size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".gltf") continue;
    const Model model = importGltf(entry.path());
    EXPECT_GE(skinnedTriangles(model), 4u) << entry.path();
    expectValidArrays(model);
    expectValidSkins(model);
    ++files;
  }
  EXPECT_EQ(files, 16u);
}

TEST(ImportCharacters, IsRepeatable) {
  const std::filesystem::path path = modelPath("valid_asian_f3.glb");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not at hand";
  const Model a = importGltf(path), b = importGltf(path);
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  for (size_t j = 0; j < a.joints.size(); ++j) EXPECT_EQ(a.joints[j].inverse_bind, b.joints[j].inverse_bind);
}

}  // namespace
}  // namespace lithe::bake
