// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// EXT_meshopt_compression and KHR_meshopt_compression: buffer views whose bytes are compressed.
#pragma once

#include "gltf_file.h"

namespace lithe::bake {

/// Decodes every compressed buffer view of the file, filters included; the entries of the others are empty.
/// Throws Error for damaged data and for codec versions that the linked meshoptimizer does not know.
std::vector<Bytes> decodeCompressedViews(const GltfFile& file);

}  // namespace lithe::bake
