// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "attributes.h"

#include <gtest/gtest.h>

#include "small_mesh.h"

namespace lithe::bake {
namespace {

using Values = std::vector<int32_t>;

Values between(const AttributeSet& attributes, const Values& from, const Values& to, int32_t t8, bool makes_faces) {
  const WedgeRecord record = wedgeRecord(attributes);
  EXPECT_EQ(record.stride, from.size());
  Values out(record.stride);
  attributesBetween(record, from.data(), to.data(), {7, t8, makes_faces}, out.data());
  return out;
}

Values between(const AttributeSet& attributes, const Values& from, const Values& to, int32_t t8) {
  return between(attributes, from, to, t8, false);
}

TEST(WedgeRecords, EntriesFollowEachOtherInTheFilesOrder) {
  const WedgeRecord record = wedgeRecord({true, true, 2, 1});
  EXPECT_EQ(record.normal, 0u);
  EXPECT_EQ(record.tangent, 2u);
  EXPECT_EQ(record.uv[0], 5u);
  EXPECT_EQ(record.uv[1], 7u);
  EXPECT_EQ(record.uv[2], kNone);
  EXPECT_EQ(record.color[0], 9u);
  EXPECT_EQ(record.color[1], kNone);
  EXPECT_EQ(record.stride, 13u);
}

TEST(WedgeRecords, WhatTheMeshLacksTakesNoPlace) {
  const WedgeRecord record = wedgeRecord({false, false, 1, 0});
  EXPECT_EQ(record.normal, kNone);
  EXPECT_EQ(record.tangent, kNone);
  EXPECT_EQ(record.uv[0], 0u);
  EXPECT_EQ(record.stride, 2u);
  EXPECT_EQ(wedgeRecord({}).stride, 0u);
}

TEST(WedgeRecords, GatherPutsEveryAttributeInItsPlace) {
  Mesh mesh = test::emptyMesh({true, true, 2, 2});
  const uint32_t vertex = test::addVertex(mesh, {1, 2, 3});
  test::addWedge(mesh, vertex);
  const uint32_t wedge = test::addWedge(mesh, vertex, {31, 32});
  mesh.wedge_normal[wedge] = {11, 12};
  mesh.wedge_tangent[wedge] = {21, 22, 1};
  mesh.wedge_uv[1][wedge] = {41, 42};
  mesh.wedge_color[0][wedge] = {51, 52, 53, 54};
  mesh.wedge_color[1][wedge] = {61, 62, 63, 64};
  Values values(17, -1);
  gatherAttributes(mesh, wedge, wedgeRecord(mesh.attributes), values.data());
  EXPECT_EQ(values, (Values{11, 12, 21, 22, 1, 31, 32, 41, 42, 51, 52, 53, 54, 61, 62, 63, 64}));
}

TEST(AttributesBetween, LinearOnesLieAtTheirEighths) {
  const AttributeSet attributes{false, false, 1, 1};
  const Values from{0, 100, 255, 0, 10, 8}, to{16, 60, 0, 255, 10, 9};
  EXPECT_EQ(between(attributes, from, to, 0), from);
  EXPECT_EQ(between(attributes, from, to, 8), to);
  // floor((2 * 16 + 4) / 8) = 4, 100 + floor((-80 + 4) / 8) = 90, 255 + floor((-510 + 4) / 8) = 191, ...
  EXPECT_EQ(between(attributes, from, to, 2), (Values{4, 90, 191, 64, 10, 8}));
}

TEST(AttributesBetween, ExchangingTheEndsGivesTheSame) {
  const AttributeSet attributes{true, true, 1, 1};
  const Values from{3, 9, 7, 1, 1, 0, 100, 255, 0, 10, 8}, to{4, 2, 7, 13, 0, 17, 61, 0, 255, 10, 9};
  for (int32_t t8 = 0; t8 <= 8; ++t8)
    EXPECT_EQ(between(attributes, from, to, t8), between(attributes, to, from, 8 - t8));
}

TEST(AttributesBetween, DirectionsGoOverTheFold) {
  // (-4, -1, -2) and (-4, 1, -2): half way is (-5, 0, -2).
  EXPECT_EQ(between({true, false, 0, 0}, {1, 4}, {1, 10}, 4, true), (Values{0, 9}));
  EXPECT_EQ(between({false, true, 0, 0}, {1, 4, 1}, {1, 10, 1}, 4, true), (Values{0, 9, 1}));
}

TEST(AttributesBetween, WithoutNewFacesDirectionsAreTheNearerChilds) {
  EXPECT_EQ(between({true, false, 0, 0}, {5, 7}, {9, 8}, 3), (Values{5, 7}));
  EXPECT_EQ(between({true, false, 0, 0}, {5, 7}, {9, 8}, 5), (Values{9, 8}));
}

TEST(AttributesBetween, DirectionsLieHalfWayWhereTheSplitMakesFaces) {
  const AttributeSet attributes{true, true, 1, 0};
  const Values from{5, 7, 9, 7, 1, 0, 100}, to{9, 7, 7, 9, 0, 16, 60};
  EXPECT_EQ(between(attributes, from, to, 0, true), (Values{7, 7, 8, 8, 1, 0, 100}));
  EXPECT_EQ(between(attributes, from, to, 2, true), (Values{7, 7, 8, 8, 1, 4, 90}));
  EXPECT_EQ(between(attributes, from, to, 8, false), to);
}

TEST(AttributesBetween, HandednessIsTheNearerChilds) {
  const AttributeSet attributes{false, true, 0, 0};
  const Values negative{7, 7, 0}, positive{7, 7, 1};
  for (int32_t t8 = 0; t8 < 4; ++t8) EXPECT_EQ(between(attributes, negative, positive, t8)[2], 0);
  for (int32_t t8 = 5; t8 <= 8; ++t8) EXPECT_EQ(between(attributes, negative, positive, t8)[2], 1);
  EXPECT_EQ(between(attributes, negative, positive, 4)[2], between(attributes, positive, negative, 4)[2]);
  EXPECT_EQ(between(attributes, positive, positive, 4)[2], 1);
}

}  // namespace
}  // namespace lithe::bake
