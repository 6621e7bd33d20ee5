// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Whatever the mesh and whatever its collapses, every level that the runtime decodes is the cut that the bake meant,
// and the finest one is the mesh, to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "lithe/bake/encode.h"
#include "lithe/format/octahedral.h"
#include "lithe/runtime.h"
#include "malloc_allocator.h"
#include "random_character.h"

namespace lithe::test {
namespace {

using bake::kNone;

/// Everything that a corner of a triangle shows, as numbers that can be compared.
using Corner = std::vector<float>;
using TriangleSet = std::multiset<std::array<Corner, 3>>;

std::array<Corner, 3> turned(std::array<Corner, 3> triangle) {
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

struct Character {
  bake::Model model;
  bake::Mesh mesh;
  bake::CollapseSequence sequence;
  bake::Hierarchy hierarchy;
  std::vector<bake::LevelPlan> levels;
  std::vector<uint8_t> bytes;
  bake::EncodeReport report;
};

Character encodeCharacter(const CharacterShape& shape, uint64_t seed, uint32_t placement_shift, uint32_t page_splits) {
  Character c;
  c.mesh = randomMesh(shape, seed);
  c.sequence = randomCollapses(c.mesh, 9, placement_shift, shape.joints, seed + 1);
  c.hierarchy = bake::buildHierarchy(c.mesh, c.sequence, placement_shift);
  c.model.nodes = {{"root", kNone, {}}};
  for (uint32_t j = 0; j < shape.joints; ++j) {
    c.model.nodes.push_back({"joint " + std::to_string(j), 0, {}});
    c.model.joints.push_back({j + 1, glm::dmat4(1.0)});
  }
  c.model.materials = {"skin"};
  for (uint32_t p = 0; p < shape.parts; ++p) c.model.parts.push_back({"part " + std::to_string(p), 0, kNone, 0, p});
  c.model.rest_diagonal = 1.0;
  uint32_t collapses = static_cast<uint32_t>(c.sequence.collapses.size());
  for (double error = 1.0; collapses > 0; collapses = collapses / 2, error /= 2)
    c.levels.push_back({collapses, error, error / 2});
  c.levels.push_back({0, 0.0, 0.0});
  c.bytes = bake::encodeFile(
      {c.model, c.mesh, c.hierarchy, c.levels, placement_shift, 1.0, page_splits, page_splits / 4}, &c.report);
  return c;
}

/// What a wedge of the hierarchy shows at a corner, computed from the specification's formulas.
Corner expectedCorner(const Character& c, uint32_t wedge) {
  const bake::Hierarchy& h = c.hierarchy;
  const uint32_t node = h.wedge_node[wedge];
  Corner corner;
  for (int i = 0; i < 3; ++i)
    corner.push_back(static_cast<float>(c.mesh.grid.origin[i]) +
                     static_cast<float>(c.mesh.grid.step) * static_cast<float>(h.position[node][i]));
  std::vector<float> weights(c.model.joints.size(), 0.0f);
  for (uint32_t i = 0; i < h.skin[node].count; ++i) weights[h.skin[node].joint[i]] = h.skin[node].weight[i];
  corner.insert(corner.end(), weights.begin(), weights.end());
  const int32_t* record = h.wedge_attributes.data() + size_t{wedge} * h.record.stride;
  auto direction = [&](uint32_t at) {
    int32_t d[3];
    format::octahedralDirection({record[at], record[at + 1]}, format::octahedralCenter(c.mesh.normal_bits), d);
    const double length = std::sqrt(double(d[0]) * d[0] + double(d[1]) * d[1] + double(d[2]) * d[2]);
    for (int32_t x : d) corner.push_back(static_cast<float>(std::round(1000.0 * x / length)));
  };
  if (h.record.normal != kNone) direction(h.record.normal);
  if (h.record.tangent != kNone) {
    direction(h.record.tangent);
    corner.push_back(record[h.record.tangent + 2] ? 1.0f : -1.0f);
  }
  for (uint32_t s = 0; s < c.mesh.attributes.uv_sets; ++s) {
    const bake::UvGrid& grid = c.mesh.part_uv[h.wedge_part[wedge]][s];
    for (int i = 0; i < 2; ++i)
      corner.push_back(static_cast<float>(grid.offset[i]) +
                       static_cast<float>(grid.scale) *
                           static_cast<float>(record[h.record.uv[s] + static_cast<uint32_t>(i)]));
  }
  for (uint32_t s = 0; s < c.mesh.attributes.color_sets; ++s)
    for (uint32_t i = 0; i < 4; ++i) corner.push_back(static_cast<float>(record[h.record.color[s] + i]));
  corner.push_back(static_cast<float>(h.wedge_part[wedge]));
  return corner;
}

/// The cut after some collapses, straight from the hierarchy: faces whose corners lie under three different nodes,
/// faces with the same nodes in the same orientation once.
TriangleSet expectedLevel(const Character& c, uint32_t collapses) {
  const bake::Hierarchy& h = c.hierarchy;
  const uint32_t node_end = h.vertex_count + collapses;
  std::set<std::array<uint32_t, 3>> seen;
  TriangleSet set;
  for (const auto& leaf : h.face_wedges) {
    std::array<uint32_t, 3> wedges = leaf, nodes;
    for (uint32_t k = 0; k < 3; ++k) {
      while (h.parent[h.wedge_node[wedges[k]]] < node_end) wedges[k] = h.wedge_parent[wedges[k]];
      nodes[k] = h.wedge_node[wedges[k]];
    }
    if (nodes[0] == nodes[1] || nodes[1] == nodes[2] || nodes[2] == nodes[0]) continue;
    std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
    if (!seen.insert(nodes).second) continue;
    set.insert(turned({expectedCorner(c, wedges[0]), expectedCorner(c, wedges[1]), expectedCorner(c, wedges[2])}));
  }
  return set;
}

/// The same from the decoder, positions only where faces are equal: which of equal faces is drawn is the writer's
/// choice.
TriangleSet positionsOnly(const TriangleSet& set) {
  TriangleSet result;
  for (std::array<Corner, 3> triangle : set) {
    for (Corner& corner : triangle) corner.resize(3);
    result.insert(turned(triangle));
  }
  return result;
}

struct Vertex {
  float position[3], normal[3], tangent[4], uv[8][2], color[2][4];
  uint16_t joints[8];
  float weights[8];
};

lithe_vertex_layout fullLayout(const lithe_asset_info& info) {
  lithe_vertex_layout layout{};
  layout.struct_size = sizeof(layout);
  layout.stride = sizeof(Vertex);
  layout.influences = 8;
  layout.position = {LITHE_FORMAT_F32, offsetof(Vertex, position)};
  if (info.has_normals) layout.normal = {LITHE_FORMAT_F32, offsetof(Vertex, normal)};
  if (info.has_tangents) layout.tangent = {LITHE_FORMAT_F32, offsetof(Vertex, tangent)};
  for (uint32_t s = 0; s < info.uv_sets; ++s)
    layout.uv[s] = {LITHE_FORMAT_F32, static_cast<uint16_t>(offsetof(Vertex, uv) + 8 * s)};
  for (uint32_t s = 0; s < info.color_sets; ++s)
    layout.color[s] = {LITHE_FORMAT_F32, static_cast<uint16_t>(offsetof(Vertex, color) + 16 * s)};
  layout.joints = {LITHE_FORMAT_U16, offsetof(Vertex, joints)};
  layout.weights = {LITHE_FORMAT_F32, offsetof(Vertex, weights)};
  return layout;
}

TriangleSet decodedLevel(const Character& c, const lithe_asset* asset, uint32_t index) {
  lithe_asset_info info;
  lithe_asset_describe(asset, &info);
  lithe_level level;
  EXPECT_EQ(lithe_asset_level(asset, index, &level), LITHE_OK);
  std::vector<Vertex> vertices(level.vertex_count);
  const lithe_vertex_layout layout = fullLayout(info);
  EXPECT_EQ(lithe_asset_write_vertices(asset, &layout, 0, level.vertex_count, vertices.data(),
                                       vertices.size() * sizeof(Vertex)),
            LITHE_OK);
  std::vector<uint32_t> indices(level.index_count);
  std::vector<lithe_range> ranges(info.part_count);
  EXPECT_EQ(lithe_asset_write_indices(asset, index, LITHE_INDEX_U32, indices.data(), indices.size() * 4, ranges.data()),
            LITHE_OK);
  auto corner = [&](uint32_t index_of_vertex, uint32_t part) {
    const Vertex& v = vertices[index_of_vertex];
    Corner out(v.position, v.position + 3);
    std::vector<float> weights(c.model.joints.size(), 0.0f);
    for (uint32_t i = 0; i < 8; ++i)
      if (v.weights[i] > 0) weights[v.joints[i]] += std::round(v.weights[i] * static_cast<float>(c.mesh.weight_one));
    out.insert(out.end(), weights.begin(), weights.end());
    if (info.has_normals)
      for (float x : v.normal) out.push_back(std::round(1000.0f * x));
    if (info.has_tangents) {
      for (int i = 0; i < 3; ++i) out.push_back(std::round(1000.0f * v.tangent[i]));
      out.push_back(v.tangent[3]);
    }
    for (uint32_t s = 0; s < info.uv_sets; ++s) out.insert(out.end(), v.uv[s], v.uv[s] + 2);
    for (uint32_t s = 0; s < info.color_sets; ++s)
      for (float x : v.color[s]) out.push_back(std::round(255.0f * x));
    out.push_back(static_cast<float>(part));
    return out;
  };
  TriangleSet set;
  for (uint32_t part = 0; part < info.part_count; ++part)
    for (uint32_t i = 0; i < ranges[part].index_count; i += 3) {
      const uint32_t* at = indices.data() + ranges[part].first_index + i;
      set.insert(turned({corner(at[0], part), corner(at[1], part), corner(at[2], part)}));
    }
  return set;
}

lithe_asset* open(const std::vector<uint8_t>& bytes) {
  lithe_asset* asset = nullptr;
  lithe_diagnosis diagnosis{};
  EXPECT_EQ(lithe_asset_open(mallocAllocator(), bytes.data(), bytes.size(), &diagnosis, &asset), LITHE_OK)
      << "check " << diagnosis.check << " at " << diagnosis.offset;
  return asset;
}

/// Supplies the pages one by one and compares every level as soon as it is there.
void expectRoundTrip(const Character& c, bool equal_faces_possible) {
  lithe_asset* asset = open(c.bytes);
  ASSERT_NE(asset, nullptr);
  for (uint32_t level = 0; level < c.levels.size(); ++level) {
    lithe_request request;
    while (lithe_asset_next_request(asset, level, &request) == LITHE_OK) {
      lithe_diagnosis diagnosis{};
      ASSERT_EQ(lithe_asset_supply(asset, request.page, c.bytes.data() + request.offset, request.size, &diagnosis),
                LITHE_OK)
          << "page " << request.page << " check " << diagnosis.check << " at " << diagnosis.offset;
    }
    ASSERT_GE(lithe_asset_resident_level(asset), level);
    TriangleSet expected = expectedLevel(c, c.levels[level].collapses), decoded = decodedLevel(c, asset, level);
    EXPECT_EQ(expected.size(), decoded.size()) << "level " << level;
    if (equal_faces_possible) {
      expected = positionsOnly(expected);
      decoded = positionsOnly(decoded);
    }
    ASSERT_TRUE(expected == decoded) << "level " << level;
  }
  lithe_asset_close(asset);
}

struct CodecCase {
  const char* name;
  CharacterShape shape;
  uint32_t placement_shift;
  uint32_t page_splits;
  bool equal_faces;  ///< different faces may come to lie on the same nodes
};

std::ostream& operator<<(std::ostream& out, const CodecCase& c) { return out << c.name; }

class Codec : public testing::TestWithParam<CodecCase> {};

TEST_P(Codec, EveryLevelIsTheCutThatWasEncoded) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const Character c =
        encodeCharacter(GetParam().shape, seed * 1000, GetParam().placement_shift, GetParam().page_splits);
    expectRoundTrip(c, GetParam().equal_faces);
    if (HasFatalFailure()) return;
  }
}

CharacterShape shapeWith(auto&& change) {
  CharacterShape shape;
  change(shape);
  return shape;
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Codec,
    testing::Values(CodecCase{"torus", {}, 5, 8192, true}, CodecCase{"exact_placement", {}, 31, 8192, true},
                    CodecCase{"coarse_placement", {}, 1, 8192, true}, CodecCase{"small_pages", {}, 5, 7, true},
                    CodecCase{"patch", shapeWith([](CharacterShape& s) { s.closed = false; }), 5, 8192, true},
                    CodecCase{"seams_and_parts", shapeWith([](CharacterShape& s) {
                                s.seams = true;
                                s.parts = 3;
                              }),
                              5, 8192, true},
                    CodecCase{"all_attributes", shapeWith([](CharacterShape& s) {
                                s.attributes = {true, true, 3, 2};
                                s.seams = true;
                              }),
                              5, 50, true},
                    CodecCase{"no_attributes", shapeWith([](CharacterShape& s) {
                                s.attributes = {false, false, 0, 0};
                              }),
                              5, 8192, true},
                    CodecCase{"non_manifold", shapeWith([](CharacterShape& s) {
                                s.loose_triangles = 150;
                                s.parts = 2;
                                s.seams = true;
                              }),
                              5, 30, true},
                    CodecCase{"eight_influences", shapeWith([](CharacterShape& s) {
                                s.joints = 20;
                                s.max_influences = 8;
                              }),
                              5, 8192, true},
                    CodecCase{"one_joint", shapeWith([](CharacterShape& s) {
                                s.joints = 1;
                                s.max_influences = 1;
                              }),
                              5, 8192, true},
                    CodecCase{"larger", shapeWith([](CharacterShape& s) {
                                s.columns = 60;
                                s.rows = 50;
                                s.seams = true;
                                s.position_bits = 16;
                              }),
                              5, 400, true}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Codec, SameInputSameBytes) {
  const Character a = encodeCharacter({}, 7, 5, 100), b = encodeCharacter({}, 7, 5, 100);
  EXPECT_EQ(a.bytes, b.bytes);
}

TEST(Codec, ReportAddsUpToTheFile) {
  const Character c = encodeCharacter({}, 7, 5, 100);
  uint64_t sum = 0;
  for (const auto& kind : c.report.kinds) sum += kind.bytes;
  EXPECT_EQ(sum, c.bytes.size());
  EXPECT_EQ(c.report.levels.back().bytes_end, c.bytes.size());
}

TEST(Codec, EvictedLevelsComeBack) {
  const Character c = encodeCharacter({}, 11, 5, 60);
  lithe_asset* asset = open(c.bytes);
  const uint32_t finest = static_cast<uint32_t>(c.levels.size()) - 1;
  Random random(3);
  uint32_t wanted = finest;
  for (int round = 0; round < 12; ++round) {
    lithe_request request;
    while (lithe_asset_next_request(asset, wanted, &request) == LITHE_OK)
      ASSERT_EQ(lithe_asset_supply(asset, request.page, c.bytes.data() + request.offset, request.size, nullptr),
                LITHE_OK);
    for (uint32_t level = 0; level <= wanted; ++level)
      ASSERT_TRUE(positionsOnly(expectedLevel(c, c.levels[level].collapses)) ==
                  positionsOnly(decodedLevel(c, asset, level)));
    ASSERT_EQ(lithe_asset_evict(asset, random.below(wanted + 1)), LITHE_OK);
    wanted = random.below(finest + 1);
    wanted = std::max(wanted, lithe_asset_resident_level(asset));
  }
  lithe_asset_close(asset);
}

}  // namespace
}  // namespace lithe::test
