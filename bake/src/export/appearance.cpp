// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "appearance.h"

#include <algorithm>
#include <set>

#include "buffers.h"
#include "document.h"
#include "uri.h"

namespace lithe::bake {

namespace {

/// The part of a glTF file that says how it looks, read by the import's own reader.
struct Source {
  FileName name;
  std::filesystem::path folder;
  Json json;
  std::vector<Bytes> buffers;
};

Source readSource(const std::filesystem::path& from) {
  Source source{{from.string()}, from.parent_path(), {}, {}};
  GltfContainer container = splitContainer(source.name, readWholeFile(source.name, from));
  const nlohmann::json json = parseJson(source.name, container.json);
  source.buffers = readBuffers(source.name, json, source.folder, std::move(container.binary));
  source.json = json;
  return source;
}

// ---- Images --------------------------------------------------------------------------------------------------------

std::string mediaTypeOf(const std::string& uri) {
  std::string extension = std::filesystem::path(uri).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  if (extension == ".png") return "image/png";
  if (extension == ".jpg" || extension == ".jpeg") return "image/jpeg";
  if (extension == ".webp") return "image/webp";
  if (extension == ".ktx2") return "image/ktx2";
  return extension == ".dds" ? "image/vnd-ms.dds" : "";
}

/// Puts the image into the buffer if it lies in the source's buffer.
void embedView(const Source& source, Json& image, const std::string& place, GltfBuilder& gltf) {
  const Json views = source.json.value("bufferViews", Json::array());
  const size_t index = image["bufferView"].is_number_unsigned() ? image["bufferView"].get<size_t>() : views.size();
  if (index >= views.size()) source.name.fail(place, "its buffer view does not exist; re-export the file");
  const size_t buffer = views[index].value("buffer", size_t{0});
  const size_t offset = views[index].value("byteOffset", size_t{0}),
               length = views[index].value("byteLength", size_t{0});
  const Bytes none;
  const Bytes& bytes = buffer < source.buffers.size() ? source.buffers[buffer] : none;
  if (offset > bytes.size() || length > bytes.size() - offset) {
    source.name.fail(place, "its bytes reach beyond its buffer; re-export the file");
  }
  image["bufferView"] = gltf.addView(std::span<const uint8_t>(bytes).subspan(offset, length), ViewTarget::kPlain);
}

/// Puts an image file into the buffer if it is there; one that is missing stays referred to.
void embedFile(const Source& source, Json& image, GltfBuilder& gltf) {
  const std::string uri = image["uri"].is_string() ? image["uri"].get<std::string>() : "";
  const std::string media_type = mediaTypeOf(uri);
  if (uri.starts_with("data:") || uri.find("://") != std::string::npos || media_type.empty()) return;
  const std::filesystem::path file = source.folder / percentDecoded(uri);
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) return;
  image.erase("uri");
  image["mimeType"] = media_type;
  image["bufferView"] = gltf.addView(readWholeFile(source.name, file), ViewTarget::kPlain);
}

void copyImages(const Source& source, GltfBuilder& gltf) {
  if (!source.json.contains("images")) return;
  for (Json image : source.json["images"]) {
    const std::string place = "image " + std::to_string(gltf.json.contains("images") ? gltf.json["images"].size() : 0);
    if (image.contains("bufferView")) embedView(source, image, place, gltf);
    if (image.contains("uri")) embedFile(source, image, gltf);
    gltf.append("images", std::move(image));
  }
}

// ---- Materials -----------------------------------------------------------------------------------------------------

/// The uv set that a texture reference reads; KHR_texture_transform may choose another.
uint32_t uvSetOf(const Json& texture) {
  uint32_t set = texture.value("texCoord", 0u);
  const Json transform = texture.value("extensions", Json::object()).value("KHR_texture_transform", Json::object());
  return std::max(set, transform.value("texCoord", 0u));
}

bool isTexture(const std::string& key, const Json& value) {
  return value.is_object() && value.contains("index") && (key.ends_with("Texture") || key.ends_with("texture"));
}

/// Takes textures off a material whose uv set is not in the file.
void dropTexturesWithoutUv(Json& object, uint32_t uv_sets) {
  for (auto entry = object.begin(); entry != object.end();) {
    if (isTexture(entry.key(), entry.value()) && uvSetOf(entry.value()) >= uv_sets) {
      entry = object.erase(entry);
      continue;
    }
    if (entry.value().is_object()) dropTexturesWithoutUv(entry.value(), uv_sets);
    ++entry;
  }
}

void collectExtensions(const Json& value, std::set<std::string>& names) {
  if (value.is_object() && value.contains("extensions")) {
    for (const auto& [name, content] : value["extensions"].items()) names.insert(name);
  }
  if (!value.is_structured()) return;
  for (const Json& member : value) collectExtensions(member, names);
}

/// States the extensions that the copied objects use; required are those that the source requires.
void stateExtensions(const Source& source, GltfBuilder& gltf) {
  std::set<std::string> used, required;
  for (const char* array : {"materials", "textures", "samplers", "images"}) {
    if (gltf.json.contains(array)) collectExtensions(gltf.json[array], used);
  }
  for (const Json& name : source.json.value("extensionsRequired", Json::array())) {
    if (used.contains(name.get<std::string>())) required.insert(name.get<std::string>());
  }
  if (!used.empty()) gltf.json["extensionsUsed"] = used;
  if (!required.empty()) gltf.json["extensionsRequired"] = required;
}

/// The source's material for a name and index: the only one of that name, else the one at the index unless the names
/// differ.
uint32_t sourceMaterial(const Json& materials, const std::string& name, uint32_t index) {
  const auto nameAt = [&](size_t i) { return materials[i].value("name", std::string()); };
  uint32_t found = kNone, count = 0;
  for (uint32_t i = 0; i < materials.size() && !name.empty(); ++i) {
    if (nameAt(i) != name) continue;
    found = i;
    ++count;
  }
  if (count == 1) return found;
  const bool same_place = index < materials.size() && (name.empty() || nameAt(index).empty() || nameAt(index) == name);
  return same_place ? index : found;
}

uint32_t appendNamed(const std::string& name, GltfBuilder& gltf) {
  Json material = Json::object();
  if (!name.empty()) material["name"] = name;
  return gltf.append("materials", std::move(material));
}

}  // namespace

std::vector<uint32_t> writeNamedMaterials(const Model& model, GltfBuilder& gltf) {
  std::vector<uint32_t> indices;
  for (const std::string& name : model.materials) indices.push_back(appendNamed(name, gltf));
  return indices;
}

std::vector<uint32_t> copyAppearance(const Model& model, const std::filesystem::path& from, GltfBuilder& gltf) {
  const Source source = readSource(from);
  copyImages(source, gltf);
  const Json materials = source.json.value("materials", Json::array());
  for (const char* array : {"samplers", "textures", "materials"}) {
    if (source.json.contains(array) && !source.json[array].empty()) gltf.json[array] = source.json[array];
  }
  if (gltf.json.contains("materials")) {
    for (Json& material : gltf.json["materials"]) dropTexturesWithoutUv(material, model.attributes.uv_sets);
  }
  stateExtensions(source, gltf);
  std::vector<uint32_t> indices;
  for (uint32_t i = 0; i < model.materials.size(); ++i) {
    const uint32_t found = sourceMaterial(materials, model.materials[i], i);
    indices.push_back(found != kNone ? found : appendNamed(model.materials[i], gltf));
  }
  return indices;
}

}  // namespace lithe::bake
