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
  struct Attribute {
    uint64_t bytes = 0;
    std::vector<int32_t> values;  ///< the cloud's, point by point
  };
  std::vector<Attribute> attributes;  ///< their bytes add up to the stream
};

/// `attributes` are the stream's, `place` names it in sentences. @throws bake::Error when it is no cloud of integers
CloudBytes measureCloud(const PageTable::Stream& stream, std::span<const format::StreamAttribute> attributes,
                        const std::string& place);

}  // namespace lithe::tool
