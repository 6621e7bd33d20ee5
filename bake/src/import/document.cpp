// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#define TINYGLTF_IMPLEMENTATION
#include "document.h"

namespace lithe::bake {

namespace {

using Json = nlohmann::json;

constexpr const char* kDraco = "KHR_draco_mesh_compression";
/// Far deeper than any document, far less than what recursion through it can take.
constexpr int kMaxDepth = 200;

bool isArrayAt(const Json& object, const char* key) { return object.contains(key) && object[key].is_array(); }

/// Names are all that is wanted of materials.
void keepNamesOnly(Json& materials) {
  for (Json& material : materials) {
    if (!material.is_object()) continue;
    Json name = material.contains("name") ? material["name"] : Json("");
    material = {{"name", name}};
  }
}

/// tinygltf refuses index accessors without a buffer view, which is what Draco's are; its faces say what they would.
void dropDracoIndices(Json& meshes) {
  for (Json& mesh : meshes) {
    if (!mesh.is_object() || !isArrayAt(mesh, "primitives")) continue;
    for (Json& primitive : mesh["primitives"]) {
      if (primitive.is_object() && primitive.contains("extensions") && primitive["extensions"].contains(kDraco)) {
        primitive.erase("indices");
      }
    }
  }
}

void strip(Json& json) {
  for (const char* unread : {"buffers", "images", "textures", "samplers", "cameras", "extensions"}) json.erase(unread);
  if (isArrayAt(json, "materials")) keepNamesOnly(json["materials"]);
  if (isArrayAt(json, "meshes")) dropDracoIndices(json["meshes"]);
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

tinygltf::Model load(const FileName& name, const std::string& text) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model document;
  std::string errors, warnings;
  bool loaded = false;
  try {
    loaded = loader.LoadASCIIFromString(&document, &errors, &warnings, text.data(),
                                        static_cast<unsigned int>(text.size()), "");
  } catch (const std::bad_alloc&) {
    throw;  // that is not the document's fault
  } catch (const std::exception& exception) {
    errors = exception.what();
  }
  if (!loaded) name.fail("", "not a valid glTF document (" + firstLine(errors) + "); re-export the file");
  return document;
}

/// tinygltf leaves out primitives that it cannot parse, which would shift the numbers of those behind.
void checkPrimitives(const FileName& name, const Json& json, const tinygltf::Model& document) {
  for (size_t i = 0; i < document.meshes.size(); ++i) {
    const Json& mesh = json["meshes"][i];
    const size_t stated = isArrayAt(mesh, "primitives") ? mesh["primitives"].size() : 0;
    if (stated != document.meshes[i].primitives.size()) {
      name.fail("mesh " + std::to_string(i), "a primitive lacks its attributes; re-export the file");
    }
  }
}

void checkVersion(const FileName& name, const Json& json) {
  if (!json.is_object()) name.fail("", "not a glTF document; give a .glb or .gltf file");
  const Json& asset = json.contains("asset") ? json["asset"] : json;
  if (!asset.is_object() || !asset.contains("version") || !asset["version"].is_string()) {
    name.fail("", "the document does not state its glTF version; give a glTF 2.0 file");
  }
  const std::string version = asset["version"].get<std::string>();
  if (version.substr(0, 2) != "2.") name.fail("", "glTF version '" + version + "' is not read; export glTF 2.0");
}

}  // namespace

Json parseJson(const FileName& name, const std::string& text) {
  const auto visit = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > kMaxDepth) name.fail("", "the JSON is nested too deeply; re-export the file");
    // Not `value == "extras"`: that makes a value of the text, in a function that must not throw when there is no
    // memory.
    return !(event == Json::parse_event_t::key && value.get_ref<const std::string&>() == "extras");
  };
  Json json;
  try {
    json = Json::parse(text, visit);
  } catch (const Json::exception& exception) {
    const std::string reason = exception.what();
    name.fail("", "not glTF: its JSON is invalid (" + reason.substr(reason.find("] ") + 2) + ")");
  }
  checkVersion(name, json);
  return json;
}

tinygltf::Model parseDocument(const FileName& name, Json json) {
  strip(json);
  tinygltf::Model document = load(name, json.dump());
  checkPrimitives(name, json, document);
  return document;
}

}  // namespace lithe::bake
