// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What each attribute of a stream takes: libdraco gets the whole cloud, with its beginning, and is watched while it
/// reads.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "page_table.h"

namespace lithe::tool {

struct CloudBytes {
  std::vector<uint64_t> attributes;  ///< they add up to the stream
};

/// `attributes` are the stream's, `place` names it in sentences. @throws bake::Error when it is no cloud of integers
CloudBytes measureCloud(const PageTable::Stream& stream, std::span<const format::StreamAttribute> attributes,
                        const std::string& place);

}  // namespace lithe::tool
