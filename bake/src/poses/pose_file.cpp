// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lithe/bake/poses.h"
#include "palette.h"

namespace lithe::bake {

namespace {

using Json = nlohmann::json;

/// Where in the file we are, for the sentence of an error.
struct Place {
  std::string file;
  size_t pose = 0;
  std::string node;

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(file + ": pose " + std::to_string(pose) + (node.empty() ? "" : ", node '" + node + "'") + ": " + what);
  }
};

Json readJson(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(path.string() + ": the pose file cannot be read; check the path");
  try {
    return Json::parse(in);
  } catch (const Json::exception&) {
    throw Error(path.string() + ": the pose file is not valid JSON; see the pose file's description for its shape");
  }
}

uint32_t findNode(const Model& model, const Place& place) {
  uint32_t found = kNone;
  for (uint32_t i = 0; i < model.nodes.size(); ++i) {
    if (model.nodes[i].name != place.node) continue;
    if (found != kNone) place.fail("the character has several nodes of this name; give them different names");
    found = i;
  }
  if (found == kNone) place.fail("the character has no such node; use the names of the glTF file's joints");
  return found;
}

std::vector<double> readNumbers(const Json& value, size_t count, const std::string& property, const Place& place) {
  const std::string wanted = "'" + property + "' must be an array of " + std::to_string(count) + " numbers";
  if (!value.is_array() || value.size() != count) place.fail(wanted);
  std::vector<double> numbers;
  for (const Json& item : value) {
    if (!item.is_number()) place.fail(wanted);
    numbers.push_back(item.get<double>());
  }
  return numbers;
}

glm::dquat readRotation(const Json& value, const Place& place) {
  const std::vector<double> q = readNumbers(value, 4, "rotation", place);
  const glm::dquat rotation(q[3], q[0], q[1], q[2]);
  if (!(glm::dot(rotation, rotation) > 0.0)) place.fail("'rotation' must not be the zero quaternion");
  return glm::normalize(rotation);
}

glm::dvec3 readVector(const Json& value, const std::string& property, const Place& place) {
  const std::vector<double> v = readNumbers(value, 3, property, place);
  return {v[0], v[1], v[2]};
}

void readTransform(const Json& value, const Place& place, Transform& local) {
  if (!value.is_object()) place.fail("must be an object with translation, rotation or scale");
  for (const auto& [property, numbers] : value.items()) {
    if (property == "translation") {
      local.translation = readVector(numbers, property, place);
    } else if (property == "rotation") {
      local.rotation = readRotation(numbers, place);
    } else if (property == "scale") {
      local.scale = readVector(numbers, property, place);
    } else {
      place.fail("'" + property + "' is none of translation, rotation and scale");
    }
  }
}

Pose readPose(const Model& model, const Json& value, Place place) {
  if (!value.is_object() || !value.contains("nodes") || !value["nodes"].is_object()) {
    place.fail("must be an object with an object 'nodes'");
  }
  std::vector<Transform> locals = restLocals(model);
  for (const auto& [name, transform] : value["nodes"].items()) {
    place.node = name;
    readTransform(transform, place, locals[findNode(model, place)]);
  }
  return localPose(model, locals);
}

}  // namespace

std::vector<Pose> readPoseFile(const Model& model, const std::filesystem::path& path) {
  const Json root = readJson(path);
  if (!root.is_object() || !root.contains("poses") || !root["poses"].is_array() || root["poses"].empty()) {
    throw Error(path.string() + ": a pose file must be an object with an array 'poses' of at least one pose");
  }
  std::vector<Pose> poses;
  for (const Json& value : root["poses"]) {
    poses.push_back(readPose(model, value, {path.string(), poses.size(), {}}));
  }
  return poses;
}

}  // namespace lithe::bake
