// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
/// The property tests' characters by name, with every level resident.
#pragma once

#include <gtest/gtest.h>

#include "asset_reader.h"
#include "property_characters.h"

namespace lithe::test {

class DecodedCharacter : public testing::TestWithParam<std::string> {
 protected:
  const PropertyCharacter& character = propertyCharacter(GetParam());
  AssetReader asset{character.bytes};

  void SetUp() override {
    ASSERT_NE(asset.get(), nullptr);
    asset.supplyThrough(asset.info().level_count - 1);
    ASSERT_EQ(lithe_asset_resident_level(asset.get()), asset.info().level_count - 1);
  }
  uint32_t levelCount() const { return asset.info().level_count; }
};

}  // namespace lithe::test
