// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/import.h"

#include <new>

#include "bind_space.h"
#include "clips.h"
#include "directions.h"
#include "geometry.h"
#include "inventory.h"
#include "range.h"
#include "scene.h"
#include "skeleton.h"
#include "winding.h"

namespace lithe::bake {

namespace {

Model readModel(const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  const GltfFile file = readGltfFile(path);
  const SceneTree tree = readScene(file, warnings);
  const Inventory inventory = takeInventory(file, tree, warnings);
  Draft draft = readGeometry(file, inventory);
  if (draft.model.triangles.empty()) file.name.fail("", "the scene shows no triangles; export a mesh with its skin");
  turnMirroredParts(draft, tree);
  completeDirections(draft);
  unifyBindSpace(draft, tree);
  const std::vector<uint32_t> node_index = buildSkeleton(draft, tree, file);
  draft.model.clips = readClips(file, node_index, warnings);
  requireRange(file.name, draft.model);
  warnings.insert(warnings.end(), draft.model.warnings.begin(), draft.model.warnings.end());
  draft.model.warnings = std::move(warnings);
  return std::move(draft.model);
}

}  // namespace

Model importGltf(const std::filesystem::path& path) {
  try {
    return readModel(path);
  } catch (const std::bad_alloc&) {
    throw Error(path.string() + ": it needs more memory than there is; bake it on a larger machine");
  }
}

}  // namespace lithe::bake
