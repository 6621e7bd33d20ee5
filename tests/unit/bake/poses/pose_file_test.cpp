// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fstream>

#include "arm.h"
#include "lithe/bake/poses.h"

namespace lithe::bake {
namespace {

std::filesystem::path writePoseFile(const std::string& text) {
  const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / ("pose_file_" + name + ".json");
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// What reading the text as a pose file throws; the file's path is cut off.
std::string complaint(const Model& model, const std::string& text) {
  const std::filesystem::path path = writePoseFile(text);
  try {
    readPoseFile(model, path);
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find(path.string() + ": "), 0u) << what;
    return what.substr(path.string().size() + 2);
  }
  return "nothing";
}

TEST(PoseFile, ReplacesWhatItNamesAndNoMore) {
  const Model arm = makeArm();
  const std::vector<Pose> poses = readPoseFile(arm, writePoseFile(R"({"poses": [
      {"nodes": {"elbow": {"rotation": [0, 0, 2, 2]}}},
      {"nodes": {"shoulder": {"translation": [0, 5, 0]}, "elbow": {"scale": [2, 2, 2]}}}]})"));
  ASSERT_EQ(poses.size(), 2u);
  const glm::dvec3 turned = skinPositions(arm, poses[0])[2], moved = skinPositions(arm, poses[1])[2];
  EXPECT_LT(glm::length(turned - glm::dvec3(2, 1, 0)), 1e-6);
  EXPECT_LT(glm::length(moved - glm::dvec3(4, 5, 0)), 1e-6);
}

TEST(PoseFile, IsUsedInsteadOfClips) {
  Model arm = makeArm();
  arm.clips.push_back({"rest", 0, 0, {}});
  const std::filesystem::path path = writePoseFile(R"({"poses": [{"nodes": {}}, {"nodes": {}}]})");
  EXPECT_EQ(choosePoses(arm, {16, {}, path}).size(), 2u);
}

TEST(PoseFile, ComplainsInOneSentence) {
  const Model arm = makeArm();
  EXPECT_THROW(readPoseFile(arm, "no/such/file.json"), Error);
  EXPECT_NE(complaint(arm, "{").find("not valid JSON"), std::string::npos);
  EXPECT_NE(complaint(arm, "[]").find("an array 'poses'"), std::string::npos);
  EXPECT_NE(complaint(arm, R"({"poses": []})").find("at least one pose"), std::string::npos);
  EXPECT_NE(complaint(arm, R"({"poses": [{}]})").find("an object 'nodes'"), std::string::npos);
  EXPECT_EQ(complaint(arm, R"({"poses": [{"nodes": {}}, {"nodes": {"knee": {}}}]})"),
            "pose 1, node 'knee': the character has no such node; use the names of the glTF file's joints");
  EXPECT_EQ(complaint(arm, R"({"poses": [{"nodes": {"elbow": {"rotation": [0, 0, 1]}}}]})"),
            "pose 0, node 'elbow': 'rotation' must be an array of 4 numbers");
  EXPECT_NE(complaint(arm, R"({"poses": [{"nodes": {"elbow": {"scale": [1, 1, "1"]}}}]})").find("3 numbers"),
            std::string::npos);
  EXPECT_NE(complaint(arm, R"({"poses": [{"nodes": {"elbow": {"rotation": [0, 0, 0, 0]}}}]})").find("zero quaternion"),
            std::string::npos);
  EXPECT_NE(complaint(arm, R"({"poses": [{"nodes": {"elbow": {"matrix": []}}}]})").find("'matrix' is none of"),
            std::string::npos);
}

TEST(PoseFile, RefusesAmbiguousNames) {
  Model arm = makeArm();
  arm.nodes[1].name = "shoulder";
  EXPECT_NE(complaint(arm, R"({"poses": [{"nodes": {"shoulder": {}}}]})").find("several nodes"), std::string::npos);
}

}  // namespace
}  // namespace lithe::bake
