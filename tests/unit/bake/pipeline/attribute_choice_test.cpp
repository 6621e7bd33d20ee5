// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "attribute_choice.h"

#include <gtest/gtest.h>

namespace lithe::bake {
namespace {

/// Two vertices with normals, tangents, `uv_sets` and `color_sets`; those listed as flat are the same at both.
Model modelWith(uint32_t uv_sets, uint32_t color_sets, bool flat_uv0 = false, bool flat_color0 = false) {
  Model model;
  model.attributes = {true, true, uv_sets, color_sets};
  for (uint32_t s = 0; s < uv_sets; ++s)
    model.uvs[s] = {{0, 0}, flat_uv0 && s == 0 ? glm::vec2(0, 0) : glm::vec2(1, 0)};
  for (uint32_t s = 0; s < color_sets; ++s)
    model.colors[s] = {glm::vec4(1), flat_color0 && s == 0 ? glm::vec4(1) : glm::vec4(0)};
  return model;
}

struct Choice {
  AttributeSet set;
  std::vector<std::string> warnings;
};

Choice choose(const Model& model, const std::vector<std::string>& names = {}) {
  Choice choice;
  choice.set = chooseAttributes(model, names, choice.warnings);
  return choice;
}

std::string refusal(const Model& model, const std::vector<std::string>& names) {
  try {
    choose(model, names);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(AttributeChoice, DefaultIsNormalsTangentsAndTheFirstSets) {
  const Choice choice = choose(modelWith(1, 1));
  EXPECT_TRUE(choice.set.normal);
  EXPECT_TRUE(choice.set.tangent);
  EXPECT_EQ(choice.set.uv_sets, 1u);
  EXPECT_EQ(choice.set.color_sets, 1u);
  EXPECT_TRUE(choice.warnings.empty());
}

TEST(AttributeChoice, DefaultTakesNothingThatTheModelLacks) {
  const Choice choice = choose(Model());
  EXPECT_FALSE(choice.set.normal);
  EXPECT_FALSE(choice.set.tangent);
  EXPECT_EQ(choice.set.uv_sets, 0u);
  EXPECT_EQ(choice.set.color_sets, 0u);
}

TEST(AttributeChoice, WhatIsTheSameEverywhereIsLeftOutSilently) {
  const Choice choice = choose(modelWith(1, 1, true, true));
  EXPECT_EQ(choice.set.uv_sets, 0u);
  EXPECT_EQ(choice.set.color_sets, 0u);
  EXPECT_TRUE(choice.warnings.empty());
}

TEST(AttributeChoice, FurtherSetsAreLeftOutWithAWarning) {
  EXPECT_EQ(choose(modelWith(2, 0)).warnings,
            std::vector<std::string>{"uv1 left out; name them in --attributes to keep them"});
  EXPECT_EQ(choose(modelWith(4, 2)).warnings,
            std::vector<std::string>{"uv1 to uv3, color1 left out; name them in --attributes to keep them"});
}

TEST(AttributeChoice, NamesChooseExactlyWhatTheySay) {
  const Choice normal = choose(modelWith(3, 2), {"normal"});
  EXPECT_TRUE(normal.set.normal);
  EXPECT_FALSE(normal.set.tangent);
  EXPECT_EQ(normal.set.uv_sets, 0u);
  EXPECT_TRUE(normal.warnings.empty());
  const Choice many = choose(modelWith(3, 2), {"tangent", "uv0", "color1"});
  EXPECT_FALSE(many.set.normal);
  EXPECT_TRUE(many.set.tangent);
  EXPECT_EQ(many.set.uv_sets, 1u);
  EXPECT_EQ(many.set.color_sets, 2u) << "color1 brings color0";
  EXPECT_EQ(choose(modelWith(3, 0), {"uv2", "uv0"}).set.uv_sets, 3u) << "uv2 brings uv0 and uv1";
}

TEST(AttributeChoice, WhatTheModelLacksIsRefused) {
  EXPECT_EQ(refusal(modelWith(2, 0), {"uv2"}), "--attributes: the model has no uv2: leave it out");
  EXPECT_EQ(refusal(modelWith(2, 0), {"color0"}), "--attributes: the model has no color0: leave it out");
  EXPECT_EQ(refusal(Model(), {"normal"}), "--attributes: the model has no normal: leave it out");
  EXPECT_EQ(refusal(Model(), {"tangent"}), "--attributes: the model has no tangent: leave it out");
}

TEST(AttributeChoice, UnknownNamesAreRefused) {
  for (const char* name : {"", "uv", "uv00", "uvx", "colour0", "Normal", "uv0 "})
    EXPECT_EQ(refusal(modelWith(2, 2), {name}), "--attributes: unknown attribute '" + std::string(name) +
                                                    "': use normal, tangent, uv0 to uv7, color0, color1");
}

}  // namespace
}  // namespace lithe::bake
