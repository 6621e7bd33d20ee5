// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// What each attribute of a stream takes: libdraco decodes the cloud and is watched while it reads.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lithe::tool {

struct CloudBytes {
  struct Attribute {
    uint64_t bytes = 0;
    std::vector<int32_t> values;  ///< the cloud's, point by point
  };
  std::vector<Attribute> attributes;
  uint64_t header_bytes = 0;  ///< everything that is no attribute's: the rest of the cloud
};

/// `place` names the stream in sentences. @throws bake::Error when it is no cloud of integers
CloudBytes measureCloud(std::span<const uint8_t> cloud, const std::string& place);

}  // namespace lithe::tool
