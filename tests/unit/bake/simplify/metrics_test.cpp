// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Every metric against a handful of triangles whose cost and best place are worked out on paper, above each test.
//
// In all of them a face of area F adds F/3 times the squared distance to its plane at each of its corners, and edges
// add nothing. Lengths are grid steps. Edges run from a = (0, 0, 0) to b = (h, 0, 0), and no plane is tilted along y
// unless it is the plane y = 0: what is said about x and z holds for every y.
#include <gtest/gtest.h>

#include "lithe/bake/simplify.h"
#include "metric.h"

namespace lithe::bake {
namespace {

using Matrix = glm::dmat4;

constexpr double kRounding = 2e-5;  // of a cost: floats hold the posed positions

Matrix scaled(const glm::dvec3& by, const glm::dvec3& moved = glm::dvec3(0.0)) {
  Matrix m(1.0);
  for (int axis = 0; axis < 3; ++axis) m[axis][axis] = by[axis];
  m[3] = glm::dvec4(moved, 1.0);
  return m;
}

Matrix moved(const glm::dvec3& by) { return scaled(glm::dvec3(1.0), by); }

/// About the line through (x, ., 0) along y: the direction of x goes to (c, ., -s), that of z to (s, ., c).
Matrix turnedAbout(double x, double c, double s) {
  Matrix m(1.0);
  m[0] = {c, 0, -s, 0};
  m[2] = {s, 0, c, 0};
  m[3] = {x - c * x, 0, s * x, 1};
  return m;
}

/// Triangles on a grid of step 1, and poses of their joints.
class Triangles {
 public:
  explicit Triangles(uint32_t joints) : joints_(joints) {
    mesh_.grid.bits = 10;
    mesh_.weight_one = 15;
  }

  uint32_t vertex(const glm::ivec3& position, uint16_t joint = 0) {
    QuantizedSkin skin;
    skin.count = 1;
    skin.joint[0] = joint;
    skin.weight[0] = static_cast<uint16_t>(mesh_.weight_one);
    mesh_.positions.push_back(position);
    mesh_.skins.push_back(skin);
    mesh_.wedge_vertex.push_back(mesh_.vertexCount() - 1);
    return mesh_.vertexCount() - 1;
  }

  void triangle(uint32_t a, uint32_t b, uint32_t c) { mesh_.triangles.push_back({a, b, c}); }

  void pose(const std::vector<Matrix>& palette) { poses_.emplace_back().palette = palette; }

  const Mesh& mesh() const { return mesh_; }
  const std::vector<Pose>& poses() const { return poses_; }
  std::vector<Joint> joints() const { return std::vector<Joint>(joints_); }

 private:
  uint32_t joints_;
  Mesh mesh_;
  std::vector<Pose> poses_;
};

/// One metric at work on triangles.
class Judge {
 public:
  static SimplifyOptions optionsFor(const std::string& metric) {
    SimplifyOptions options;
    options.metric = metric;
    options.placement_shift = 31;
    options.boundary_weight = options.seam_weight = options.fold_weight = 0.0;
    return options;
  }

  Judge(const std::string& metric, const Triangles& t) : Judge(optionsFor(metric), t) {}
  Judge(const SimplifyOptions& options, const Triangles& t)
      : options_(options),
        nodes_{t.mesh().grid.bits,
               options_.placement_shift,
               t.mesh().weight_one,
               t.mesh().max_influences,
               t.mesh().positions,
               t.mesh().skins,
               poseMesh(t.mesh(), palettesOf(options.metric, t.joints(), t.poses()))},
        surface_(t.mesh()),
        metric_(makeMetric({nodes_, surface_, options_})),
        placer_(nodes_) {
    surface_.classifyEdges(nodes_.posed);
    std::vector<FanFace> fan;
    for (uint32_t slot = 0; slot < t.mesh().vertexCount(); ++slot) metric_->refresh(slot, fan);
  }

  Placement place(uint32_t a, uint32_t b) { return inSteps(metric_->place(a, b, placer_)); }

  QuantizedSkin skinBetween(uint32_t a, uint32_t b, int32_t t8) const { return placer_.skinBetween(a, b, t8); }

  /// After place().
  Placement improveSkin(uint32_t a, uint32_t b, Placement placement, QuantizedSkin& skin) {
    placement.cost /= unit4();
    metric_->improveSkin(a, b, placer_, placement, skin);
    return inSteps(placement);
  }

  /// After place(), of two vertices with one skin.
  void merge(uint32_t a, uint32_t b, const Placement& parent) {
    metric_->merge(a, b, parent, placer_.posed.data());
    nodes_.positions[a] = parent.position;
    std::copy(placer_.posed.begin(), placer_.posed.end(), nodes_.posed.at(a));
    std::vector<uint32_t> thirds;
    surface_.collapse(a, b, thirds);
  }

  /// Where the last placement lies in a pose, from where `origin` lies there.
  glm::dvec3 posedFrom(uint32_t origin, uint32_t pose) const {
    const PosedPoint &p = placer_.posed[0], &o = nodes_.posed.at(origin)[0];
    return glm::dvec3(p.x[pose] - o.x[pose], p.y[pose] - o.y[pose], p.z[pose] - o.z[pose]) * nodes_.posed.unit;
  }

 private:
  double unit4() const { return std::pow(nodes_.posed.unit, 4); }

  Placement inSteps(Placement placement) const {
    placement.cost *= unit4();
    return placement;
  }

  SimplifyOptions options_;
  NodeState nodes_;
  Surface surface_;
  std::unique_ptr<Metric> metric_;
  EdgePlacer placer_;
};

void expectPlacement(const Placement& found, const glm::ivec3& position, int32_t t8, double cost) {
  EXPECT_EQ(found.position, position);
  EXPECT_EQ(found.t8, t8);
  EXPECT_NEAR(found.cost, cost, kRounding * cost);
}

QuantizedSkin skinOf(uint32_t count, std::array<uint16_t, 2> joints, std::array<uint16_t, 2> weights) {
  QuantizedSkin skin;
  skin.count = static_cast<uint8_t>(count);
  std::copy(joints.begin(), joints.end(), skin.joint.begin());
  std::copy(weights.begin(), weights.end(), skin.weight.begin());
  return skin;
}

/// One joint. a's face of area 135 lies in x = 0, b's of area 375 in 3 (x - 60) + 4 z = 0, theirs of area 30 `width` in
/// z = 0.
struct Knee : Triangles {
  explicit Knee(int32_t width) : Triangles(1), a(vertex({0, 0, 0})), b(vertex({60, 0, 0})), c(vertex({30, width, 0})) {
    triangle(a, b, c);
    triangle(a, vertex({0, 15, 0}), vertex({0, 0, 18}));
    triangle(b, vertex({60, 15, 0}), vertex({20, 0, 30}));
  }
  uint32_t a, b, c;
};

// E = 45 x^2 + 125 s^2 + 160 z^2 with s = (3 (x - 60) + 4 z) / 5: both ends have the face between them, of area 240.
// 45 x = -75 s and 160 z = -100 s give s = -14.4, x = 24, z = 9 and E = 25920 + 25920 + 12960.
TEST(Metrics, RestIsTheBestPlaceInTheBindPoseAndReadsNoOther) {
  Knee knee(8);
  knee.pose({scaled({3.0, 1.0, 5.0})});
  expectPlacement(Judge("rest", knee).place(knee.a, knee.b), {24, 0, 9}, 3, 64800.0);
}

// The parent keeps all of E, and c brings 80 z^2 more, of the face that is gone: 45 x = -75 s and 240 z = -100 s give
// s = -108/7, x = 180/7, z = 45/7. The nearest grid point is (26, ., 6): 45 * 676 + 125 * 15.6^2 + 240 * 36.
// The start is the middle (27, 4, 5), whose y nothing moves.
TEST(Metrics, RestAddsUpWhatWasThere) {
  Knee knee(8);
  Judge judge("rest", knee);
  judge.merge(knee.a, knee.b, judge.place(knee.a, knee.b));
  expectPlacement(judge.place(knee.a, knee.c), {26, 4, 6}, 3, 69480.0);
}

/// a, c and a's face (area 300, in x = 0) on joint 0; b and b's face (area 300, in x = 40) on joint 1.
struct Slider : Triangles {
  Slider() : Triangles(2), a(vertex({0, 0, 0})), b(vertex({40, 0, 0}, 1)) {
    triangle(a, b, vertex({20, 30, 0}));
    triangle(a, vertex({0, 30, 0}), vertex({0, 0, 20}));
    triangle(b, vertex({40, 30, 0}, 1), vertex({40, 0, 20}, 1));
  }
  /// b's side moves by -x and grows along z: its face has `growth` times the area.
  void slide(double x, double growth) { pose({Matrix(1.0), scaled({1.0, 1.0, growth}, {-x, 0.0, 0.0})}); }
  uint32_t a, b;
};

// Pose 0: the face at the other end is 40 away and has a third of 300. Pose 1: 20 away; b's has a third of 600.
// At a: 100 * 1600 + 200 * 400 = 240000. At b: 100 * 1600 + 100 * 400 = 200000. Between them it would be less.
TEST(Metrics, DsdIsTheCheaperEndInAllPosesWithItsOwnSkin) {
  Slider slider;
  slider.slide(0.0, 1.0);
  slider.slide(20.0, 2.0);
  Judge judge("dsd", slider);
  expectPlacement(judge.place(slider.a, slider.b), {40, 0, 0}, 8, 200000.0);
  EXPECT_EQ(judge.skinBetween(slider.a, slider.b, 8), skinOf(1, {1, 0}, {15, 0}));
  EXPECT_LT(glm::distance(judge.posedFrom(slider.a, 0), {40.0, 0.0, 0.0}), 1e-4);
  EXPECT_LT(glm::distance(judge.posedFrom(slider.a, 1), {20.0, 0.0, 0.0}), 1e-4);
}

// Four poses as they are, one with b at 15: dsd takes b, 4 * 100 * 1600 + 100 * 225 = 662500 (a: 685000).
// The edge: lengths 40, 40, 40, 40, 15, mean 35; changes 5, 5, 5, 5, 20, mean 8; their deviation is the root of
// (4 * 25 + 400) / 5, 10, so w = 20 / 10. The faces at it: 600 and 800 in four poses, 225 and 300 in one, mean 1225.
// d = 2 * 1225 * 8^2 = 156800.
TEST(Metrics, DodAddsWhatTheEdgeChangesItsLength) {
  Slider slider;
  slider.triangle(slider.b, slider.a, slider.vertex({20, 0, 40}));
  for (int i = 0; i < 4; ++i) slider.slide(0.0, 1.0);
  slider.slide(25.0, 2.0);
  expectPlacement(Judge("dod", slider).place(slider.a, slider.b), {40, 0, 0}, 8, 662500.0 + 156800.0);
}

// A third of 300, 40 away: 160000 a pose at either end, and nothing beside it.
TEST(Metrics, DodIsDsdWhereLengthsStayOrThereIsOnePose) {
  Slider slider;
  slider.slide(0.0, 1.0);
  expectPlacement(Judge("dod", slider).place(slider.a, slider.b), {0, 0, 0}, 0, 160000.0);
  const Matrix turn = turnedAbout(7.0, 0.6, 0.8);
  slider.pose({turn, turn});
  slider.slide(0.0, 1.0);
  const double dod = Judge("dod", slider).place(slider.a, slider.b).cost;
  EXPECT_NEAR(dod, 480000.0, 480000.0 * kRounding);
  EXPECT_EQ(dod, Judge("dsd", slider).place(slider.a, slider.b).cost);
}

// Pose 0 is the bind pose; in pose 1 joint 1 (b and its face) is turned by a right angle about b, which stays where it
// is. Pulled back through its own vertex' matrix, each face of one joint is what it was: 2 * 500 x^2 from a's, of area
// 1500 in x = 0, and 2 * 750 s^2 from b's, of area 2250 in 3 (x - 80) + 4 z = 0. The one between, of area 1920 in z =
// 0, says z at a twice and at b once; b's pose 1 takes it for x - 80: E = 1000 x^2 + 1500 s^2 + 3 * 640 z^2 + 640 (x -
// 80)^2. At (40, ., 10), s = -16: dE/dx / 2 = 40000 - 14400 - 25600 = 0 and dE/dz / 2 = -19200 + 19200 = 0. E = 1600000
// + 384000 + 192000 + 1024000.
TEST(Metrics, PoseIndependentPullsEveryQuadricBackThroughItsVertex) {
  Triangles t(2);
  const uint32_t a = t.vertex({0, 0, 0}), b = t.vertex({80, 0, 0}, 1);
  t.triangle(a, b, t.vertex({40, 48, 0}));
  t.triangle(a, t.vertex({0, 50, 0}), t.vertex({0, 0, 60}));
  t.triangle(b, t.vertex({80, 45, 0}, 1), t.vertex({0, 0, 60}, 1));
  t.pose({Matrix(1.0), Matrix(1.0)});
  t.pose({Matrix(1.0), turnedAbout(80.0, 0.0, 1.0)});
  Judge judge("pose-independent", t);
  expectPlacement(judge.place(a, b), {40, 0, 10}, 4, 3200000.0);
  EXPECT_EQ(judge.skinBetween(a, b, 4).count, 2);
}

// Pose 0: a's face has 720 in x = 0, b's 3000 in 3 (x - 80) + 4 z = 0, the one between 280 in z = 0. In pose 1 joint 1
// doubles the first and the last along y, and joint 2 turns b's about b into z = 0. The face between counts once:
// E = (240 + 480) x^2 + 1000 s^2 + ((280 + 560) / 3 + 1000) z^2.
// 720 x = -600 s and 1280 z = -800 s give s = -24, x = 20, z = 15 and E = 288000 + 576000 + 288000.
TEST(Metrics, ArticulatedIsTheBestPlaceForAllPosesTogether) {
  Triangles t(3);
  const uint32_t a = t.vertex({0, 0, 0}), b = t.vertex({80, 0, 0});
  t.triangle(a, b, t.vertex({40, 7, 0}, 1));
  t.triangle(a, t.vertex({0, 36, 0}, 1), t.vertex({0, 0, 40}, 1));
  t.triangle(b, t.vertex({80, 60, 0}, 2), t.vertex({0, 0, 60}, 2));
  t.pose({Matrix(1.0), Matrix(1.0), Matrix(1.0)});
  t.pose({Matrix(1.0), scaled({1.0, 2.0, 1.0}), turnedAbout(80.0, 0.8, -0.6)});
  expectPlacement(Judge("articulated", t).place(a, b), {20, 0, 15}, 2, 1152000.0);
}

// The face between has area 60, and what is now says E = 45 x^2 + 125 s^2 + 20 z^2: s = -6, x = 10, z = 30,
// E = 4500 + 4500 + 18000. What was counts it at both ends, 18000 more, and two thirds of 45000 are above 27000.
TEST(Metrics, ArticulatedIsGuardedByTwoThirdsOfWhatWas) {
  Knee knee(2);
  knee.pose({Matrix(1.0)});
  expectPlacement(Judge("articulated", knee).place(knee.a, knee.b), {10, 0, 30}, 1, 30000.0);
}

// x counts from a. Upright faces, in both poses: 45 in x = 0 at a, 15 in x = 80 at b; the one between lies in y = 0.
// Level faces: 9000 at a and 13500 at b, and in pose 1 a fifteenth of that, b's side 15 higher. With w of joint 1:
// E = 30 x^2 + 10 (x - 80)^2 + 7500 z^2 + 200 (z + 15 w)^2 + 300 (z + 15 w - 15)^2.
// x = 20 whatever the weights are, 48000. The skin at its two eighths has w = 4/15: the least z is 25/80, on the grid
// 0; 200 * 16 + 300 * 121 = 39500 more. The best w at z = 0 is 3/5: 200 * 81 + 300 * 36 = 27000.
TEST(Metrics, ArticulatedFindsTheWeightsToo) {
  Triangles t(4);
  const uint32_t a = t.vertex({200, 0, 0}), b = t.vertex({280, 0, 0}, 1);
  t.triangle(a, b, t.vertex({240, 0, 60}));
  t.triangle(a, t.vertex({200, 10, 0}), t.vertex({200, 0, 9}));
  t.triangle(b, t.vertex({280, 10, 0}, 1), t.vertex({280, 0, 3}, 1));
  t.triangle(a, t.vertex({200, 150, 0}, 2), t.vertex({80, 0, 0}));
  t.triangle(b, t.vertex({280, 150, 0}, 3), t.vertex({460, 0, 0}, 1));
  const glm::dvec3 up(0.0, 0.0, 15.0), flat(1.0, 1.0 / 15.0, 1.0);
  t.pose({Matrix(1.0), Matrix(1.0), Matrix(1.0), Matrix(1.0)});
  t.pose({Matrix(1.0), moved(up), scaled(flat), scaled(flat, up)});
  SimplifyOptions options = Judge::optionsFor("articulated");
  options.weight_gain = 0.14;
  Judge judge(options, t);
  const Placement interpolated = judge.place(a, b);
  expectPlacement(interpolated, {220, 0, 0}, 2, 87500.0);
  QuantizedSkin skin = judge.skinBetween(a, b, 2);
  EXPECT_EQ(skin, skinOf(2, {0, 1}, {11, 4}));
  expectPlacement(judge.improveSkin(a, b, interpolated, skin), {220, 0, 0}, 2, 75000.0);
  EXPECT_EQ(skin, skinOf(2, {1, 0}, {9, 6}));

  // A seventh is all there is to gain, which is not worth its bytes when more is asked for.
  options.weight_gain = 0.15;
  Judge stricter(options, t);
  skin = stricter.skinBetween(a, b, 2);
  expectPlacement(stricter.improveSkin(a, b, stricter.place(a, b), skin), {220, 0, 0}, 2, 87500.0);
  EXPECT_EQ(skin, skinOf(2, {0, 1}, {11, 4}));
}

}  // namespace
}  // namespace lithe::bake
