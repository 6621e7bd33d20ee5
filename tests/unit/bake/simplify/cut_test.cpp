// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/cut.h"

#include <gtest/gtest.h>

#include "meshes.h"

namespace lithe::bake {
namespace {

using namespace test;

/// A tube of two parts with uvs: u runs around and jumps from 1 to 0 at the seam.
Model texturedTube() {
  Model model = tube(12, 20);
  model.parts.resize(2);
  for (size_t t = 12 * 20; t < model.triangle_part.size(); ++t) model.triangle_part[t] = 1;
  model.attributes.normal = true;
  model.attributes.uv_sets = 1;
  for (const glm::vec3& p : model.positions) {
    model.normals.push_back(glm::normalize(glm::vec3(p.x, 0.1f, p.z)));
    model.uvs[0].emplace_back(0.5 + std::atan2(p.z, p.x) / 6.283185307179586, p.y / 4.0);
  }
  return model;
}

TEST(Cut, CountsCollapsesUpToTheTarget) {
  const Mesh mesh = weldQuietly(tube(12, 20));
  const CollapseSequence sequence = simplify(mesh, std::vector<Joint>(2), bendingPoses(3, 60.0, 2.0), {});
  EXPECT_EQ(collapsesToReach(sequence, mesh, mesh.triangleCount()), 0u);
  const uint32_t count = collapsesToReach(sequence, mesh, 100);
  EXPECT_LE(sequence.collapses[count - 1].triangles, 100u);
  EXPECT_GT(sequence.collapses[count - 2].triangles, 100u);
  EXPECT_EQ(collapsesToReach(sequence, mesh, 0), sequence.collapses.size());
}

TEST(Cut, WithoutCollapsesIsTheMesh) {
  const Model original = texturedTube();
  const Mesh mesh = weldQuietly(original);
  const Model cut = cutToModel(original, mesh, {}, mesh.triangleCount());
  ASSERT_EQ(cut.triangles.size(), mesh.triangles.size());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    EXPECT_EQ(cut.triangle_part[t], original.triangle_part[t]);
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t v = cut.triangles[t][k], source = original.triangles[t][k];
      EXPECT_LT(glm::distance(cut.positions[v], original.positions[source]), 3e-4f);
      EXPECT_GT(glm::dot(cut.normals[v], original.normals[source]), 0.9999f);
      EXPECT_LT(glm::distance(cut.uvs[0][v], original.uvs[0][source]), 3e-4f);
      EXPECT_NEAR(cut.skins[v].weight[0], original.skins[source].weight[0], 0.5 / 255 + 1e-6);
    }
  }
}

TEST(Cut, HasTheTrianglesTheSequencePromisesAtEveryCount) {
  const Model original = texturedTube();
  const Mesh mesh = weldQuietly(original);
  const CollapseSequence sequence = simplify(mesh, std::vector<Joint>(2), bendingPoses(3, 60.0, 2.0), {});
  for (uint32_t i = 0; i < sequence.collapses.size(); i += 11) {
    const Model cut = cutToModel(original, mesh, sequence, sequence.collapses[i].triangles);
    EXPECT_EQ(cut.triangles.size(), sequence.collapses[i].triangles);
    EXPECT_EQ(cut.triangles.size(), cut.triangle_part.size());
    for (const auto& triangle : cut.triangles) {
      for (uint32_t v : triangle) ASSERT_LT(v, cut.positions.size());
    }
  }
}

TEST(Cut, WedgesMeetAcrossDyingTrianglesAndNowhereElse) {
  // Two quads side by side with a seam between them; the seam's upper edge collapses half-way.
  Model model = emptyModel(2);
  model.attributes.uv_sets = 1;
  const auto corner = [&](float x, float y, float u, float v) {
    model.uvs[0].emplace_back(u, v);
    return addVertex(model, {x, y, 0.0f}, oneJoint(0));
  };
  const uint32_t a = corner(0, 0, 0, 0), b = corner(1, 0, 0.25f, 0), c = corner(1, 1, 0.25f, 0.25f),
                 d = corner(0, 1, 0, 0.25f);
  const uint32_t e = corner(1, 0, 0.5f, 0), f = corner(2, 0, 1, 0), g = corner(2, 1, 1, 1), h = corner(1, 1, 0.5f, 1);
  addTriangle(model, a, b, d);
  addTriangle(model, b, c, d);
  addTriangle(model, e, f, h);
  addTriangle(model, f, g, h);
  WeldOptions options;
  options.uv_bits = 10;
  const Mesh mesh = weldQuietly(model, options);
  ASSERT_EQ(mesh.vertexCount(), 6u);
  CollapseSequence sequence;
  sequence.collapses.resize(1);
  Collapse& collapse = sequence.collapses[0];
  collapse.child[0] = mesh.corner(0, 1);  // the seam's lower vertex, b and e
  collapse.child[1] = mesh.corner(1, 1);  // the seam's upper vertex, c and h
  collapse.t8 = 4;
  collapse.position = {8191, 4096, 0};
  collapse.skin = mesh.skins[0];
  collapse.triangles = 2;
  const Model cut = cutToModel(model, mesh, sequence, 2);
  ASSERT_EQ(cut.triangles.size(), 2u);
  // Left: (a, w, d), w between b (0.25, 0) and c (0.25, 0.25). Right: (f, g, w), w between e (0.5, 0) and h (0.5, 1).
  const glm::vec2 left = cut.uvs[0][cut.triangles[0][1]], right = cut.uvs[0][cut.triangles[1][2]];
  EXPECT_NEAR(left.x, 0.25, 1e-3);
  EXPECT_NEAR(left.y, 0.125, 2e-3);
  EXPECT_NEAR(right.x, 0.5, 1e-3);
  EXPECT_NEAR(right.y, 0.5, 2e-3);
  EXPECT_EQ(cut.positions[cut.triangles[0][1]], cut.positions[cut.triangles[1][2]]);
}

}  // namespace
}  // namespace lithe::bake
