// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What a bake says of its work: the same figures for people and for programs.
#pragma once

#include <string>

#include "lithe/bake/bake.h"

namespace lithe::tool {

/// Tables of levels, bytes and seconds, ending in a newline.
std::string bakeText(const bake::BakeReport& report, const std::string& input, const std::string& output);

/// {input, output, bytes, head_bytes, source: {...}, levels: [{triangles, vertices, error, bytes, ...}], kinds, stages,
/// warnings}
std::string bakeJson(const bake::BakeReport& report, const std::string& input, const std::string& output);

}  // namespace lithe::tool
