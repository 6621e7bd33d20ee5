// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/simplify.h"

#include <gtest/gtest.h>

#include "lithe/bake/nearest.h"
#include "lithe/bake/skin_weights.h"
#include "meshes.h"
#include "random.h"

namespace lithe::bake {
namespace {

using namespace test;

CollapseSequence run(const Mesh& mesh, const std::vector<Pose>& poses, const SimplifyOptions& options) {
  return simplify(mesh, std::vector<Joint>(2), poses, options);
}

class EveryMetric : public testing::TestWithParam<std::string> {
 protected:
  SimplifyOptions options(uint32_t min_triangles = 0) const {
    SimplifyOptions result;
    result.metric = GetParam();
    result.min_triangles = min_triangles;
    result.threads = 1;
    return result;
  }
};

INSTANTIATE_TEST_SUITE_P(Metrics, EveryMetric, testing::ValuesIn(metricNames()), [](const auto& named) {
  std::string name = named.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(EveryMetric, KeepsItsPromisesOnABendingTube) {
  const Mesh mesh = weldQuietly(tube(16, 24));
  const CollapseSequence sequence = run(mesh, bendingPoses(5, 90.0, 2.0), options());
  EXPECT_EQ(sequence.collapses.back().triangles, 0u);
  expectValid(mesh, sequence, options());
}

TEST_P(EveryMetric, AFlatPatchIsFreeUntilItsCornersGo) {
  Model model = emptyModel(2);
  addGrid(model, 8, [](double, double) { return oneJoint(0); });
  const Mesh mesh = weldQuietly(model);
  const CollapseSequence sequence = run(mesh, bendingPoses(3, 60.0, 0.0), options(2));
  EXPECT_EQ(sequence.collapses.back().triangles, 2u);
  double sum = 0.0;
  for (const Collapse& c : sequence.collapses) sum += c.cost;
  EXPECT_LT(sum, 0.02);  // an area of 64 times (1/60)^2: what the tie-break and the grid leave
  const auto triangles = trianglesAfter(mesh, sequence, static_cast<uint32_t>(sequence.collapses.size()));
  std::set<std::pair<int, int>> corners;
  for (const auto& t : triangles) {
    for (uint32_t node : t) {
      const glm::ivec3 p =
          node < mesh.vertexCount() ? mesh.positions[node] : sequence.collapses[node - mesh.vertexCount()].position;
      corners.insert({p.x, p.y});
      EXPECT_EQ(p.z, 0);
    }
  }
  EXPECT_EQ(corners, (std::set<std::pair<int, int>>{{0, 0}, {0, 16383}, {16383, 0}, {16383, 16383}}));
}

TEST_P(EveryMetric, TheThreadCountChangesNothing) {
  const Mesh mesh = weldQuietly(tube(24, 60));
  SimplifyOptions one = options(), four = options();
  one.levels = four.levels = {1500, 700, 200};
  four.threads = 4;
  const std::vector<Pose> poses = bendingPoses(9, 80.0, 2.0);
  EXPECT_TRUE(sameCollapses(run(mesh, poses, one), run(mesh, poses, four)));
}

TEST_P(EveryMetric, AClosedMeshStaysClosed) {
  const Mesh mesh = weldQuietly(tube(12, 20));
  const CollapseSequence sequence = run(mesh, bendingPoses(4, 90.0, 2.0), options());
  for (uint32_t count = 0; count < sequence.collapses.size(); count += 5) {
    EXPECT_EQ(openEdges(trianglesAfter(mesh, sequence, count)), 0u) << count;
  }
}

TEST_P(EveryMetric, ReachesAnyTargetOnNonManifoldManyComponentInput) {
  lithe::test::Random random(3);
  Model model = emptyModel(2);
  for (uint32_t i = 0; i < 120; ++i) {
    addVertex(model, glm::vec3(random.unit(), random.unit(), random.unit()), twoJoints(random.unit()));
  }
  for (uint32_t t = 0; t < 400; ++t) {  // soup: edges with up to many faces
    const uint32_t a = random.below(120), b = (a + 1 + random.below(6)) % 120, c = (a + 7 + random.below(6)) % 120;
    addTriangle(model, a, b, c);
  }
  for (uint32_t i = 0; i < 40; ++i) {  // cards of two triangles
    const glm::vec3 corner(random.unit(), random.unit(), 1.0 + random.unit());
    addGrid(
        model, 1, [](double, double) { return oneJoint(1); }, corner);
  }
  const Mesh mesh = weldQuietly(model);
  const CollapseSequence sequence = run(mesh, bendingPoses(3, 45.0, 0.5), options(10));
  ASSERT_FALSE(sequence.collapses.empty());
  EXPECT_LE(sequence.collapses.back().triangles, 10u);
  const auto reached = std::find_if(sequence.collapses.begin(), sequence.collapses.end(),
                                    [](const Collapse& c) { return c.triangles <= 10; });
  for (auto it = reached; it != sequence.collapses.end(); ++it) {
    EXPECT_EQ(it->triangles, reached->triangles) << "only absorptions follow";
  }
  expectValid(mesh, sequence, options());
}

TEST(Simplify, SomethingIsLeftUnlessNothingIsAskedFor) {
  const Mesh mesh = weldQuietly(tube(16, 24));
  SimplifyOptions options;
  options.min_triangles = 1;
  const CollapseSequence sequence = run(mesh, bendingPoses(4, 90.0, 2.0), options);
  ASSERT_FALSE(sequence.collapses.empty());
  EXPECT_GT(sequence.collapses.back().triangles, 0u);
  EXPECT_LE(sequence.collapses.back().triangles, 2u);
}

TEST(Simplify, StopsAtTheTarget) {
  const Mesh mesh = weldQuietly(tube(16, 24));
  SimplifyOptions options;
  options.min_triangles = 300;
  double last_progress = -1.0;
  options.progress = [&](double p) {
    EXPECT_GE(p, last_progress);
    last_progress = p;
  };
  const CollapseSequence sequence = run(mesh, bendingPoses(4, 90.0, 2.0), options);
  EXPECT_LE(sequence.collapses.back().triangles, 300u);
  EXPECT_GE(sequence.collapses.back().triangles, 296u);
  EXPECT_EQ(last_progress, 1.0);
  options.min_triangles = 100000;
  EXPECT_TRUE(run(mesh, bendingPoses(4, 90.0, 2.0), options).collapses.empty());
}

TEST_P(EveryMetric, RefitsKeepItsPromises) {
  const Mesh mesh = weldQuietly(tube(16, 24));
  const std::vector<Pose> poses = bendingPoses(5, 90.0, 2.0);
  SimplifyOptions refit = options(), plain = options();
  refit.levels = plain.levels = {100, 500, 250};
  plain.refit = false;
  const CollapseSequence sequence = run(mesh, poses, refit), collapsed = run(mesh, poses, plain);
  expectValid(mesh, sequence, refit);
  const bool same = std::equal(sequence.collapses.begin(), sequence.collapses.end(), collapsed.collapses.begin(),
                               collapsed.collapses.end(),
                               [](const Collapse& a, const Collapse& b) { return a.position == b.position; });
  EXPECT_EQ(same, refit.metric != "articulated") << "the other metrics leave their vertices where they put them";
}

TEST(Simplify, HoldsEveryCap) {
  lithe::test::Random random(6);
  Model model = tube(12, 30);
  model.joints.resize(6);
  for (Skin& skin : model.skins) {
    skin = {};
    skin.count = 4;
    double left = 1.0;
    for (uint32_t k = 0; k < 4; ++k) {
      skin.joint[k] = static_cast<uint16_t>((random.below(2) + k) % 6);
      const double share = k == 3 ? left : left * (0.3 + 0.3 * random.unit());
      skin.weight[k] = static_cast<float>(share);
      left -= share;
    }
    std::set<uint16_t> distinct(skin.joint.begin(), skin.joint.begin() + 4);
    if (distinct.size() < 4) skin = oneJoint(2);
  }
  std::vector<Pose> poses(6);
  for (uint32_t p = 0; p < 6; ++p) {
    for (uint32_t j = 0; j < 6; ++j) {
      glm::dmat4 m(1.0);
      m[3] = glm::dvec4(0.3 * std::sin(p + 2.0 * j), 0.2 * std::cos(3.0 * p + j), 0.1 * p * j, 1.0);
      poses[p].palette.push_back(m);
    }
  }
  for (const uint32_t cap : {1u, 2u, 4u, 8u}) {
    WeldOptions weld_options;
    weld_options.max_influences = cap;
    const Mesh mesh = weldQuietly(model, weld_options);
    SimplifyOptions options;
    options.weight_gain = 0.0;
    const CollapseSequence sequence = simplify(mesh, std::vector<Joint>(6), poses, options);
    expectValid(mesh, sequence, options);
  }
}

/// Root mean square distance of the mesh's vertices to what is left of it, in one pose.
double posedError(const Mesh& mesh, const CollapseSequence& sequence, const Pose& pose) {
  std::vector<glm::dvec3> posed;
  const auto append = [&](const glm::ivec3& position, const QuantizedSkin& skin) {
    const glm::dvec4 rest(mesh.grid.origin + mesh.grid.step * glm::dvec3(position), 1.0);
    glm::dvec3 sum(0.0);
    for (uint32_t k = 0; k < skin.count; ++k) {
      sum += skin.weight[k] / double(mesh.weight_one) * glm::dvec3(pose.palette[skin.joint[k]] * rest);
    }
    posed.push_back(sum);
  };
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) append(mesh.positions[v], mesh.skins[v]);
  for (const Collapse& c : sequence.collapses) append(c.position, c.skin);
  const TriangleTree tree(posed, trianglesAfter(mesh, sequence, static_cast<uint32_t>(sequence.collapses.size())));
  double sum = 0.0;
  for (uint32_t v = 0; v < mesh.vertexCount(); ++v) sum += tree.nearest(posed[v]).distance2;
  return std::sqrt(sum / mesh.vertexCount());
}

TEST(Simplify, TheRestPoseSaysNothingAboutABendAndTheArticulatedMetricDoes) {
  // A flat strip: at rest every collapse is free, so `rest` spends nothing on the bend in its middle.
  Model model = emptyModel(2);
  addGrid(model, 24, [](double x, double) { return twoJoints((x - 0.45) / 0.1); });
  std::vector<Pose> poses(3);
  for (uint32_t p = 0; p < 3; ++p) {
    const double angle = 0.8 * p, c = std::cos(angle), s = std::sin(angle);
    glm::dmat4 turn(1.0);
    turn[0] = {c, 0, s, 0};
    turn[2] = {-s, 0, c, 0};
    turn[3] = {12.0 - 12.0 * c, 0, -12.0 * s, 1};
    poses[p].palette = {glm::dmat4(1.0), turn};
  }
  const Mesh mesh = weldQuietly(model);
  SimplifyOptions options;
  options.min_triangles = 16;
  options.metric = "rest";
  const double rest = posedError(mesh, run(mesh, poses, options), poses[2]);
  options.metric = "articulated";
  const double articulated = posedError(mesh, run(mesh, poses, options), poses[2]);
  EXPECT_LT(articulated, 0.6 * rest);
}

TEST(Simplify, KeepsABorderWithItsWeightAndLosesItWithout) {
  // A disc with a zigzag border: flat, so only the border's quadrics know that the teeth matter.
  Model model = emptyModel(2);
  addGrid(model, 16, [](double, double) { return oneJoint(0); });
  for (uint32_t x = 0; x <= 16; ++x) model.positions[x].y -= x % 4 < 2 ? 0.5f : 0.0f;
  const Mesh mesh = weldQuietly(model);
  const auto borderCost = [&](double weight) {
    SimplifyOptions options;
    options.min_triangles = 60;
    options.boundary_weight = weight;
    const CollapseSequence sequence = run(mesh, restPoses(2), options);
    double area = 0.0;
    for (const auto& t : trianglesAfter(mesh, sequence, static_cast<uint32_t>(sequence.collapses.size()))) {
      glm::dvec3 p[3];
      for (uint32_t k = 0; k < 3; ++k) {
        const bool leaf = t[k] < mesh.vertexCount();
        p[k] = glm::dvec3(leaf ? mesh.positions[t[k]] : sequence.collapses[t[k] - mesh.vertexCount()].position) *
               mesh.grid.step;
      }
      area += 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
    }
    return std::abs(area - 256.0 - 0.5 * 8.0);
  };
  EXPECT_LT(borderCost(1.0), 0.3 * borderCost(0.0));
}

TEST(Simplify, ASmallFarComponentOutlivesTheFactorZero) {
  Model model = tube(16, 24);
  addGrid(model, 1, [](double, double) { return oneJoint(1); }, {3.0f, 3.0f, 0.0f});
  const Mesh mesh = weldQuietly(model);
  const auto survives = [&](double factor) {
    SimplifyOptions options;
    options.min_triangles = 40;
    options.vanish_factor = options.vanish_factor_coarse = factor;
    const CollapseSequence sequence = run(mesh, bendingPoses(3, 60.0, 2.0), options);
    const auto triangles = trianglesAfter(mesh, sequence, static_cast<uint32_t>(sequence.collapses.size()));
    return std::any_of(triangles.begin(), triangles.end(), [&](const auto& t) {
      const glm::ivec3 p =
          t[0] < mesh.vertexCount() ? mesh.positions[t[0]] : sequence.collapses[t[0] - mesh.vertexCount()].position;
      return mesh.grid.origin.x + mesh.grid.step * p.x > 2.0;
    });
  };
  EXPECT_TRUE(survives(1000.0));
}

TEST(Simplify, InterpolatedSkinsUnlessOptimisedOnesPay) {
  const Mesh mesh = weldQuietly(tube(16, 40));
  const auto optimisedShare = [&](double gain) {
    SimplifyOptions options;
    options.min_triangles = 100;
    options.weight_gain = gain;
    const CollapseSequence sequence = run(mesh, bendingPoses(8, 100.0, 2.0), options);
    std::vector<QuantizedSkin> skins = mesh.skins;
    uint32_t other = 0;
    for (const Collapse& c : sequence.collapses) {
      other +=
          c.skin == interpolateSkin(skins[c.child[0]], skins[c.child[1]], c.t8, mesh.weight_one, mesh.max_influences)
              ? 0
              : 1;
      skins.push_back(c.skin);
    }
    return double(other) / sequence.collapses.size();
  };
  EXPECT_EQ(optimisedShare(1.0), 0.0);
  EXPECT_GT(optimisedShare(0.0), optimisedShare(0.05));
  EXPECT_GT(optimisedShare(0.05), 0.0);
}

TEST(Simplify, RefusesUnknownMetricsAndPosesThatDoNotFit) {
  const Mesh mesh = weldQuietly(tube(8, 8));
  SimplifyOptions options;
  options.metric = "magic";
  try {
    run(mesh, bendingPoses(2, 30.0, 2.0), options);
    FAIL();
  } catch (const Error& error) {
    for (const std::string& name : metricNames()) EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
  }
  options.metric = "articulated";
  EXPECT_THROW(run(mesh, {}, options), Error);
  EXPECT_THROW(simplify(mesh, std::vector<Joint>(3), bendingPoses(2, 30.0, 2.0), options), Error);
  options.metric = "rest";
  EXPECT_NO_THROW(run(mesh, {}, options));
}

TEST(Simplify, UnitsOfTheModelDoNotMatter) {
  Model model = tube(16, 24);
  std::vector<Pose> poses = bendingPoses(4, 90.0, 2.0);
  const CollapseSequence metres = run(weldQuietly(model), poses, {});
  for (glm::vec3& p : model.positions) p *= 1024.0f;
  for (Pose& pose : poses) {
    for (glm::dmat4& m : pose.palette) m[3] *= glm::dvec4(1024.0, 1024.0, 1024.0, 1.0);
  }
  const CollapseSequence large = run(weldQuietly(model), poses, {});
  ASSERT_EQ(metres.collapses.size(), large.collapses.size());
  for (size_t i = 0; i < metres.collapses.size(); ++i) {
    EXPECT_EQ(metres.collapses[i].position, large.collapses[i].position);
    EXPECT_NEAR(large.collapses[i].cost, metres.collapses[i].cost * std::pow(1024.0, 4),
                large.collapses[i].cost * 1e-9);
  }
}

}  // namespace
}  // namespace lithe::bake
