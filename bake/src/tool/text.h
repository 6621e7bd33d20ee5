// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// Small helpers for what the tool prints.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lithe::tool {

/// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

/// 1234567 -> "1,234,567"
std::string grouped(uint64_t number);

/// Columns aligned to the right (the first `left` ones to the left), two blanks between them, one line per row.
std::string table(const std::vector<std::vector<std::string>>& rows, size_t left = 0);

}  // namespace lithe::tool
