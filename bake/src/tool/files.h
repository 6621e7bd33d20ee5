// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Whole files in, and texts out; see lithe/bake/output_files.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace lithe::tool {

/// @throws bake::Error naming the file when it cannot be read
std::vector<uint8_t> readFile(const std::filesystem::path& path);

/// The bytes of a text; as long-lived as the text.
std::span<const uint8_t> bytesOf(std::string_view text);

/// Writes a text as bake::writeTogether does. The path "-" means stdout.
void writeText(const std::filesystem::path& path, std::string_view text);

}  // namespace lithe::tool
