// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The Draco clouds that are the streams of a .lithe page, found by its own stream table.
#pragma once

#include <memory>
#include <vector>

#include "cloud_set.h"
#include "lithe/runtime.h"

namespace lithe::bench {

/// One set per page, in order: what lithe_asset_supply decodes in one call each.
/// @throws bake::Error when a page is not what docs/format.md says
std::vector<std::unique_ptr<CloudSet>> pageClouds(const lithe_asset& asset, const std::vector<uint8_t>& bytes);

}  // namespace lithe::bench
