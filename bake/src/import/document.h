// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The JSON of a glTF file, checked for what tinygltf takes on trust.
#pragma once

#include <nlohmann/json.hpp>

#include "gltf_file.h"

namespace lithe::bake {

/// Parses the JSON without extras. Throws Error for anything but a glTF 2.x object of sane depth.
nlohmann::json parseJson(const FileName& name, const std::string& text);

/// The document that tinygltf makes of the JSON once everything that the import never reads is removed from it.
/// Throws Error where tinygltf does, and where it would drop a primitive in silence.
tinygltf::Model parseDocument(const FileName& name, nlohmann::json json);

}  // namespace lithe::bake
