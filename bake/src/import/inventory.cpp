// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "inventory.h"

#include <algorithm>

namespace lithe::bake {

namespace {

bool has(const tinygltf::Primitive& primitive, const std::string& attribute) {
  return primitive.attributes.count(attribute) != 0;
}

/// Why a primitive has no triangles to read; empty if it may have some.
std::string reasonToLeaveOut(const tinygltf::Primitive& primitive) {
  if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    return "its mode " + std::to_string(primitive.mode) + " is not glTF's, and it is left out";
  }
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) return "it is made of points or lines, and is left out";
  return has(primitive, "POSITION") ? "" : "it has no positions, and is left out";
}

void checkReferences(const GltfFile& file, uint32_t node) {
  const tinygltf::Node& stated = file.document.nodes[node];
  if (static_cast<size_t>(stated.mesh) >= file.document.meshes.size()) {
    file.name.fail(nodePlace(file, node), "there is no mesh " + std::to_string(stated.mesh) + "; re-export the file");
  }
  if (stated.skin >= 0 && static_cast<size_t>(stated.skin) >= file.document.skins.size()) {
    file.name.fail(nodePlace(file, node), "there is no skin " + std::to_string(stated.skin) + "; re-export the file");
  }
}

void listUses(const GltfFile& file, uint32_t node, std::vector<PrimitiveUse>& uses,
              std::vector<std::string>& warnings) {
  checkReferences(file, node);
  const uint32_t mesh = static_cast<uint32_t>(file.document.nodes[node].mesh);
  const auto& primitives = file.document.meshes[mesh].primitives;
  for (uint32_t i = 0; i < primitives.size(); ++i) {
    PrimitiveUse use{node, mesh, i, file.document.nodes[node].skin >= 0};
    const std::string reason = reasonToLeaveOut(primitives[i]);
    if (!reason.empty()) {
      warnings.push_back(primitivePlace(file, use) + ": " + reason);
      continue;
    }
    if (use.skinned && !(has(primitives[i], "JOINTS_0") && has(primitives[i], "WEIGHTS_0"))) {
      warnings.push_back(primitivePlace(file, use) + ": it has a skin but no weights, and is bound to its node");
      use.skinned = false;
    }
    uses.push_back(use);
  }
}

/// How many sets there are from 0 on without a gap, in any of the primitives.
uint32_t leadingSets(const GltfFile& file, const std::vector<PrimitiveUse>& uses, const char* base) {
  uint32_t sets = 0;
  while (std::any_of(uses.begin(), uses.end(),
                     [&](const PrimitiveUse& use) { return has(primitiveOf(file, use), attributeName(base, sets)); })) {
    ++sets;
  }
  return sets;
}

uint32_t limitSets(uint32_t sets, uint32_t limit, const char* what, std::vector<std::string>& warnings) {
  if (sets > limit) {
    warnings.push_back("the file has " + std::to_string(sets) + " " + what + "; those beyond " + std::to_string(limit) +
                       " are dropped");
  }
  return std::min(sets, limit);
}

AttributeSet findAttributes(const GltfFile& file, const std::vector<PrimitiveUse>& uses,
                            std::vector<std::string>& warnings) {
  AttributeSet attributes;
  attributes.normal = true;
  attributes.tangent = std::any_of(uses.begin(), uses.end(),
                                   [&](const PrimitiveUse& use) { return has(primitiveOf(file, use), "TANGENT"); });
  attributes.uv_sets = limitSets(leadingSets(file, uses, "TEXCOORD"), kMaxUvSets, "uv sets", warnings);
  attributes.color_sets = limitSets(leadingSets(file, uses, "COLOR"), kMaxColorSets, "colour sets", warnings);
  return attributes;
}

void warnOfMorphTargets(const GltfFile& file, const std::vector<PrimitiveUse>& uses,
                        std::vector<std::string>& warnings) {
  size_t most = 0;
  for (const PrimitiveUse& use : uses) most = std::max(most, primitiveOf(file, use).targets.size());
  if (most > 0) {
    warnings.push_back("morph targets are not supported: up to " + std::to_string(most) + " per mesh are dropped");
  }
}

/// Extensions that change geometry are read or refused elsewhere; what is left concerns looks, or is unknown to us.
void warnOfUnknownExtensions(const GltfFile& file, std::vector<std::string>& warnings) {
  for (const std::string& extension : file.document.extensionsRequired) {
    const auto begins = [&](const char* prefix) { return extension.rfind(prefix, 0) == 0; };
    const bool known = begins("KHR_draco") || begins("KHR_mesh_quantization") || begins("EXT_meshopt") ||
                       begins("KHR_meshopt") || begins("KHR_texture") || begins("EXT_texture") ||
                       begins("MSFT_texture") || begins("KHR_materials") || begins("KHR_lights");
    if (!known) warnings.push_back("the file requires the extension '" + extension + "', which is ignored");
  }
}

}  // namespace

std::string attributeName(const char* base, uint32_t set) { return std::string(base) + "_" + std::to_string(set); }

Inventory takeInventory(const GltfFile& file, const SceneTree& tree, std::vector<std::string>& warnings) {
  Inventory inventory;
  for (uint32_t node = 0; node < file.document.nodes.size(); ++node) {
    if (tree.shown[node] && file.document.nodes[node].mesh >= 0) listUses(file, node, inventory.uses, warnings);
  }
  inventory.attributes = findAttributes(file, inventory.uses, warnings);
  warnOfMorphTargets(file, inventory.uses, warnings);
  warnOfUnknownExtensions(file, warnings);
  return inventory;
}

}  // namespace lithe::bake
