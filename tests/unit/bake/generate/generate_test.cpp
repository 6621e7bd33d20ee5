// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
#include "lithe/bake/generate.h"

#include <gtest/gtest.h>

#include "model_checks.h"

namespace lithe::bake {
namespace {

TEST(Generate, RefusesAnUnknownNameAndListsTheKnownOnes) {
  try {
    generate("unicorn");
    FAIL() << "no error";
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("unicorn"), std::string::npos);
    for (const std::string& name : generatorNames()) EXPECT_NE(sentence.find(name), std::string::npos) << sentence;
  }
}

class EveryCharacter : public testing::TestWithParam<std::string> {};

TEST_P(EveryCharacter, IsTheSameEachTime) {
  EXPECT_TRUE(checks::sameModel(generate(GetParam()), generate(GetParam())));
}

INSTANTIATE_TEST_SUITE_P(Names, EveryCharacter, testing::ValuesIn(generatorNames()),
                         [](const auto& character) { return character.param; });

}  // namespace
}  // namespace lithe::bake
