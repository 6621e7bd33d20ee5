// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Whole files in and out. A file appears under its name when it is complete, or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace lithe::tool {

/// @throws bake::Error naming the file when it cannot be read
std::vector<uint8_t> readFile(const std::filesystem::path& path);

/// Writes to a file beside the target and renames it; an existing target is replaced in one step. When something fails
/// the target is as it was and nothing is left beside it.
/// @throws bake::Error naming the file when it cannot be written
void writeFile(const std::filesystem::path& path, std::span<const uint8_t> bytes);

/// The same for text. The path "-" means stdout.
void writeText(const std::filesystem::path& path, std::string_view text);

/// Checks early, before minutes of work, that `path` can become a file: its folder exists and it is not a folder
/// itself.
/// @throws bake::Error
void requireWritable(const std::filesystem::path& path);

}  // namespace lithe::tool
