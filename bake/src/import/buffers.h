// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The buffers of a glTF document: a GLB's binary chunk, files beside it, and data URIs.
#pragma once

#include <nlohmann/json.hpp>

#include "gltf_file.h"

namespace lithe::bake {

/// Reads every buffer of the document. A buffer without data (a fallback for compressed views) stays empty.
/// @param folder  what relative URIs are relative to
/// @param binary  the binary chunk of a GLB
/// Throws Error if one is missing, is shorter than the document states, or is on a network.
std::vector<Bytes> readBuffers(const FileName& name, const nlohmann::json& json, const std::filesystem::path& folder,
                               Bytes binary);

/// Bytes [offset, offset + length) of a buffer. Throws Error if the buffer does not have them.
std::span<const uint8_t> bufferRange(const GltfFile& file, int64_t buffer, uint64_t offset, uint64_t length,
                                     const std::string& place);

}  // namespace lithe::bake
