// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "lithe/bake/generate.h"
#include "model_checks.h"

namespace lithe::bake {
namespace {

class ColumnTest : public testing::Test {
 protected:
  static const Model& column() { return checks::character("column"); }
};

TEST_F(ColumnTest, KeepsThePromisesOfEveryCharacter) { EXPECT_EQ(checks::brokenPromise(column(), 2), ""); }

TEST_F(ColumnTest, HasTheTriangleCountOfTheLiterature) {
  EXPECT_EQ(column().triangles.size(), 114'688u);
  EXPECT_EQ(column().joints.size(), 4u);
  EXPECT_NEAR(column().rest_diagonal, std::sqrt(1.0 + 64.0 + 1.0), 1e-12);
}

TEST_F(ColumnTest, IsOneClosedBoxOnceWelded) {
  const checks::Topology topology = checks::measureTopology(column());
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.boundary_edges + topology.crowded_edges + topology.flipped_edges, 0u);
  EXPECT_EQ(topology.pinched_vertices + topology.degenerate_triangles, 0u);
  EXPECT_EQ(topology.vertices + topology.triangles, topology.edges + 2u);  // Euler: a sphere
  EXPECT_NEAR(checks::signedVolume(column()), 8.0, 1e-5);
  EXPECT_EQ(checks::outwardNormals(column()), 1.0);
}

TEST_F(ColumnTest, HasHardEdges) {
  // two wedges to a vertex on an edge of the box, three at a corner
  // that
  const checks::Topology topology = checks::measureTopology(column());
  EXPECT_EQ(column().positions.size() - topology.vertices, 4u * (432u + 1u) + 2u * 4u * 32u);
}

TEST_F(ColumnTest, WeightsRiseSmoothlyAlongTheAxis) {
  // the mean joint of a vertex depends on y alone and never falls with y
  std::map<float, float> mean_joint;
  for (size_t vertex = 0; vertex < column().positions.size(); ++vertex) {
    const Skin& skin = column().skins[vertex];
    float mean = 0.0f;
    for (uint32_t k = 0; k < skin.count; ++k) mean += skin.weight[k] * static_cast<float>(skin.joint[k]);
    const auto entry = mean_joint.try_emplace(column().positions[vertex].y, mean).first;
    ASSERT_EQ(entry->second, mean);
  }
  float previous = 0.0f;
  for (const auto& [y, mean] : mean_joint) {
    EXPECT_GE(mean, previous) << y;
    EXPECT_LT(mean - previous, 0.05f) << y;
    previous = mean;
  }
  EXPECT_EQ(previous, 3.0f);
}

TEST_F(ColumnTest, HasFourExamplePosesAndSixtyOtherPoses) {
  const Clip* examples = checks::findClip(column(), "examples");
  const Clip* test = checks::findClip(column(), "test");
  ASSERT_TRUE(examples && test);
  ASSERT_EQ(examples->channels.size(), 3u);
  ASSERT_EQ(test->channels.size(), 3u);
  for (const Channel& channel : examples->channels) EXPECT_EQ(channel.times.size(), 4u);
  for (const Channel& channel : test->channels) {
    ASSERT_EQ(channel.times.size(), 60u);
    EXPECT_NEAR(channel.times[1], 1.0 / 30.0, 1e-7);
  }
}

TEST_F(ColumnTest, TestPosesMoveSmoothlyAndStayAsModerateAsTheExamples) {
  float largest_example = 0.0f;
  for (const Channel& channel : checks::findClip(column(), "examples")->channels) {
    for (const glm::vec4& q : channel.values) largest_example = std::max(largest_example, 2.0f * std::acos(q.w));
  }
  for (const Channel& channel : checks::findClip(column(), "test")->channels) {
    for (size_t key = 0; key < channel.values.size(); ++key) {
      EXPECT_LE(2.0f * std::acos(channel.values[key].w), largest_example);
      if (key > 0) {
        EXPECT_GT(glm::dot(channel.values[key], channel.values[key - 1]), 0.98f);
      }
    }
  }
}

}  // namespace
}  // namespace lithe::bake
