// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "lithe/bake/generate.h"
#include "lithe/bake/poses.h"
#include "model_checks.h"

namespace lithe::bake {
namespace {

class FigureTest : public testing::Test {
 protected:
  static const Model& figure() { return checks::character("figure"); }

  static uint32_t jointNamed(const std::string& name) {
    for (uint32_t j = 0; j < figure().joints.size(); ++j) {
      if (figure().nodes[figure().joints[j].node].name == name) return j;
    }
    return kNone;
  }

  static glm::dvec3 restOf(const std::string& joint) {
    return -glm::dvec3(figure().joints[jointNamed(joint)].inverse_bind[3]);
  }

  /// Where a joint lies at an instant of a clip.
  static glm::dvec3 posed(const std::string& joint, const std::string& clip, double time) {
    const auto index = static_cast<uint32_t>(checks::findClip(figure(), clip) - figure().clips.data());
    const Pose pose = clipPose(figure(), index, time);
    return glm::dvec3(pose.palette[jointNamed(joint)] * glm::dvec4(restOf(joint), 1.0));
  }

  /// Degrees between the two bones at `joint`; positive if the farther one turns backwards (a knee), negative forwards.
  static double bend(const std::string& before, const std::string& joint, const std::string& after,
                     const std::string& clip, double time) {
    const glm::dvec3 u = posed(joint, clip, time) - posed(before, clip, time);
    const glm::dvec3 v = posed(after, clip, time) - posed(joint, clip, time);
    return glm::degrees(std::atan2(u.z * -v.y - -u.y * v.z, u.y * v.y + u.z * v.z));
  }
};

TEST_F(FigureTest, KeepsThePromisesOfEveryCharacter) { EXPECT_EQ(checks::brokenPromise(figure(), 4), ""); }

TEST_F(FigureTest, IsDenseAndHasTheSizeOfAnAdult) {
  EXPECT_NEAR(static_cast<double>(figure().triangles.size()), 240e3, 15e3);
  const checks::Box box = checks::restBox(figure());
  EXPECT_NEAR(box.low.y, 0.0, 0.004);
  EXPECT_NEAR(box.high.y, 1.75, 0.015);
  EXPECT_NEAR(box.low.x, -box.high.x, 1e-3);
  const std::vector<std::string> materials = {"skin", "hair", "shorts", "eyes"};
  EXPECT_EQ(figure().materials, materials);
}

TEST_F(FigureTest, IsABodyAndTwoEyesAllClosed) {
  const checks::Topology topology = checks::measureTopology(figure());
  EXPECT_EQ(topology.components, 3u);
  EXPECT_EQ(topology.boundary_edges, 0u);
  EXPECT_EQ(topology.crowded_edges, 0u);
  EXPECT_EQ(topology.flipped_edges, 0u);
  EXPECT_EQ(topology.pinched_vertices, 0u);
  EXPECT_EQ(topology.degenerate_triangles, 0u);
  EXPECT_EQ(topology.vertices + topology.triangles, topology.edges + 2u * topology.components);
  // about 0.075 cubic metres, as a person of 75 kg has
  EXPECT_NEAR(checks::signedVolume(figure()), 0.072, 0.012);
  EXPECT_GT(checks::outwardNormals(figure()), 0.9995);
}

TEST_F(FigureTest, HasFewSlivers) {
  size_t slivers = 0;
  double sum = 0.0;
  for (uint32_t t = 0; t < figure().triangles.size(); ++t) {
    const double quality = checks::triangleQuality(figure(), t);
    slivers += quality < 0.2;
    sum += quality;
  }
  const double count = static_cast<double>(figure().triangles.size());
  EXPECT_LT(static_cast<double>(slivers) / count, 1e-3);
  EXPECT_GT(sum / count, 0.88);
}

TEST_F(FigureTest, SpendsTrianglesOnTheFace) {
  // mean edge length around the nose against that on the trunk
  double face = 0.0, trunk = 0.0, face_count = 0.0, trunk_count = 0.0;
  for (const auto& t : figure().triangles) {
    const glm::vec3 a = figure().positions[t[0]], b = figure().positions[t[1]];
    const double length = glm::length(a - b);
    if (a.y > 1.56 && a.y < 1.66 && a.z > 0.06) face += length, ++face_count;
    if (a.y > 1.1 && a.y < 1.3 && std::abs(a.x) < 0.15) trunk += length, ++trunk_count;
  }
  EXPECT_LT(face / face_count, 0.5 * trunk / trunk_count);
}

TEST_F(FigureTest, SeamsShareTheirPositionsWeights) {
  const std::vector<uint32_t> welded = checks::weldByPosition(figure());
  uint32_t shared = 0;
  for (uint32_t vertex = 0; vertex < welded.size(); ++vertex) {
    const Skin &a = figure().skins[vertex], &b = figure().skins[welded[vertex]];
    ASSERT_EQ(a.joint, b.joint) << vertex;
    ASSERT_EQ(a.weight, b.weight) << vertex;
    shared += welded[vertex] != vertex;
  }
  EXPECT_GT(shared, 1000u);
  EXPECT_LT(shared, welded.size() / 15u);  // seams, not an unindexed mesh
}

/// Where skin or hair meets another part of the body, as edges between places.
struct PartEdge {
  uint32_t a, b;
  uint32_t part, other;  ///< ascending
};

std::vector<PartEdge> partEdges(const Model& model) {
  const std::vector<uint32_t> place = checks::weldByPosition(model);
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> part_of;  // directed edge -> part
  for (uint32_t t = 0; t < model.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      part_of[{place[model.triangles[t][k]], place[model.triangles[t][(k + 1) % 3]]}] = model.triangle_part[t];
    }
  }
  std::vector<PartEdge> edges;
  for (const auto& [edge, part] : part_of) {
    const auto back = part_of.find({edge.second, edge.first});
    if (back != part_of.end() && part < back->second) edges.push_back({edge.first, edge.second, part, back->second});
  }
  return edges;
}

TEST_F(FigureTest, ShortsEndInStraightHems) {
  uint32_t waistband = 0, hems = 0;
  for (const PartEdge& edge : partEdges(figure())) {
    if (edge.other != 2) continue;  // the shorts are the third part
    for (const uint32_t vertex : {edge.a, edge.b}) {
      const float y = figure().positions[vertex].y;
      EXPECT_TRUE(std::abs(y - 0.985f) < 1e-6f || std::abs(y - 0.70f) < 1e-6f) << y;
      ++(y > 0.8f ? waistband : hems);
    }
  }
  EXPECT_GT(waistband, 150u);
  EXPECT_GT(hems, 150u);
}

TEST_F(FigureTest, EdgesOfPartsAreLinesNotTeeth) {
  std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> next;  // (parts, place) -> places along the edge
  for (const PartEdge& edge : partEdges(figure())) {
    next[{edge.other, edge.a}].push_back(edge.b);
    next[{edge.other, edge.b}].push_back(edge.a);
  }
  size_t corners = 0, sharp = 0;
  for (const auto& [key, ends] : next) {
    EXPECT_EQ(ends.size(), 2u) << "the edge branches at " << key.second;
    if (ends.size() != 2) continue;
    const glm::dvec3 here(figure().positions[key.second]);
    const glm::dvec3 in = here - glm::dvec3(figure().positions[ends[0]]);
    const glm::dvec3 out = glm::dvec3(figure().positions[ends[1]]) - here;
    ++corners;
    sharp += glm::dot(in, out) < 0.5 * glm::length(in) * glm::length(out);  // turns by more than 60 degrees
  }
  EXPECT_GT(corners, 600u);
  EXPECT_LT(static_cast<double>(sharp), 0.01 * static_cast<double>(corners)) << sharp << " of " << corners;
}

TEST_F(FigureTest, ChartsDoNotTurnInsideOutInOneHalfOfTheBody) {
  // on the left and in the middle a triangle keeps its turning sense in the texture or is next to nothing there
  double turned = 0.0, total = 0.0;
  for (const auto& t : figure().triangles) {
    if (figure().positions[t[0]].x < 0.02f) continue;
    const glm::dvec2 a = figure().uvs[0][t[0]], b = figure().uvs[0][t[1]], c = figure().uvs[0][t[2]];
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    total += std::abs(area);
    turned += area < 0.0 ? -area : 0.0;
  }
  EXPECT_LT(std::min(turned, total - turned) / total, 0.35);
  EXPECT_GT(total, 0.1);  // of the texture's square, both counted twice: half of the body uses a good part of it
}

TEST_F(FigureTest, HasAHumanSkeleton) {
  EXPECT_GE(figure().joints.size(), 50u);
  for (const std::string joint :
       {"hips", "chest", "neck", "head", "clavicle", "upper_arm", "forearm", "hand", "thumb_2", "index_2", "middle_2",
        "ring_2", "little_2", "thigh", "shin", "foot", "toes", "eye"}) {
    const bool middle = jointNamed(joint) != kNone;
    ASSERT_TRUE(middle || (jointNamed(joint + "_l") != kNone && jointNamed(joint + "_r") != kNone)) << joint;
    if (!middle) {
      EXPECT_NEAR(glm::length(restOf(joint + "_l") * glm::dvec3(-1, 1, 1) - restOf(joint + "_r")), 0.0, 1e-12) << joint;
    }
  }
}

TEST_F(FigureTest, EveryJointMovesSomething) {
  std::vector<bool> used(figure().joints.size(), false);
  for (const Skin& skin : figure().skins) {
    for (uint32_t k = 0; k < skin.count; ++k) used[skin.joint[k]] = true;
  }
  for (uint32_t j = 0; j < used.size(); ++j) EXPECT_TRUE(used[j]) << figure().nodes[figure().joints[j].node].name;
}

TEST_F(FigureTest, NoLegFollowsTheOtherLegsJoints) {
  const std::set<uint32_t> left = {jointNamed("thigh_l"), jointNamed("shin_l"), jointNamed("foot_l"),
                                   jointNamed("toes_l")};
  for (size_t v = 0; v < figure().skins.size(); ++v) {
    if (figure().positions[v].x > -0.05f) continue;
    for (uint32_t k = 0; k < figure().skins[v].count; ++k) EXPECT_FALSE(left.contains(figure().skins[v].joint[k])) << v;
  }
}

TEST_F(FigureTest, WalksAndRunsInALoopWithAFootOnTheGround) {
  for (const std::string name : {"walk", "run"}) {
    const Clip* clip = checks::findClip(figure(), name);
    ASSERT_TRUE(clip) << name;
    for (const Channel& channel : clip->channels) {
      const glm::vec4 first = channel.values.front(), last = channel.values.back();
      EXPECT_LT(std::min(glm::length(first - last), glm::length(first + last)), 1e-4f)
          << figure().nodes[channel.node].name;
    }
    for (int instant = 0; instant < 8; ++instant) {
      const double low = checks::posedBox(figure(), name, clip->end * instant / 8.0).low.y;
      EXPECT_GT(low, -0.02) << name << instant;
      EXPECT_LT(low, name == "walk" ? 0.02 : 0.12) << name << instant;
    }
  }
}

TEST_F(FigureTest, KneesBendBackwardsAndElbowsForwards) {
  for (const Clip& clip : figure().clips) {
    for (int instant = 0; instant <= 24; ++instant) {
      const double time = clip.end * instant / 24.0;
      const std::string at = clip.name + " at " + std::to_string(time);
      for (const std::string side : {"_l", "_r"}) {
        const double knee = bend("thigh" + side, "shin" + side, "foot" + side, clip.name, time);
        EXPECT_GT(knee, -3.0) << at << side;
        EXPECT_LT(knee, 150.0) << at << side;
        if (clip.name == "wave" && side == "_r") continue;  // this forearm points up
        EXPECT_LT(bend("upper_arm" + side, "forearm" + side, "hand" + side, clip.name, time), 3.0) << at << side;
      }
    }
  }
}

TEST_F(FigureTest, DoesWhatTheClipsAreNamedFor) {
  const double hips = restOf("hips").y;
  EXPECT_LT(posed("hips", "crouch", 1.0).y, hips - 0.35);
  EXPECT_LT(posed("hips", "sit", 1.3).y, hips - 0.35);
  EXPECT_LT(posed("hips", "sit", 1.3).z, restOf("hips").z - 0.3);
  EXPECT_GT(posed("hand_r", "wave", 1.5).y, posed("head", "wave", 1.5).y);
  EXPECT_LT(posed("hand_l", "wave", 1.5).y, hips);
  // the hand goes to and fro while it is up
  double left = 1e30, right = -1e30;
  for (double time = 1.0; time < 2.0; time += 1.0 / 30.0) {
    left = std::min(left, posed("middle_2_r", "wave", time).x);
    right = std::max(right, posed("middle_2_r", "wave", time).x);
  }
  EXPECT_GT(right - left, 0.1);
  // in a walk the feet pass each other
  const auto ahead = [&](double time) { return posed("foot_l", "walk", time).z - posed("foot_r", "walk", time).z; };
  EXPECT_GT(ahead(0.0), 0.4);
  EXPECT_LT(ahead(16.0 / 30.0), -0.4);
}

}  // namespace
}  // namespace lithe::bake
