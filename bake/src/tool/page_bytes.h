// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Where a file's bytes go, read from its pages' own stream tables: nothing is decoded.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "asset.h"

namespace lithe::tool {

/// Bytes by kind, as a bake reports them: "head", "base", "splits", "connectivity", ...; they add up to the file.
/// @throws bake::Error when a page's table is damaged
std::map<std::string, uint64_t> bytesByKind(const Asset& asset);

}  // namespace lithe::tool
