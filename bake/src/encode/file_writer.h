// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The head of a file: header, directory and tables.
#pragma once

#include "lithe/bake/encode.h"

namespace lithe::bake {

/// What the tables say of one page and one level, in file order.
struct PageEntry {
  uint32_t level = 0;
  uint32_t node_count = 0, wedge_count = 0, face_count = 0;
  uint32_t values = 0, max_fan = 0;
  std::vector<uint8_t> bytes;
};
struct LevelEntry {
  uint32_t page_end = 0;
  uint32_t node_count = 0, wedge_count = 0, face_count = 0, hidden_count = 0;
  uint32_t joint_count = 0;
  double error = 0.0, error_rms = 0.0;
};

/// The whole file: head and pages.
std::vector<uint8_t> writeFile(const EncodeInput& input, const std::vector<LevelEntry>& levels,
                               const std::vector<PageEntry>& pages, uint64_t* head_bytes);

}  // namespace lithe::bake
