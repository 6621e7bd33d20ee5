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
  EXPECT_TRUE(checks::sameModel(checks::character(GetParam()), generate(GetParam())));
}

TEST_P(EveryCharacter, RestsInItsBindPose) {
  const Model& model = checks::character(GetParam());
  EXPECT_LT(checks::restPoseError(model), 1e-6 * model.rest_diagonal);
}

TEST_P(EveryCharacter, HoldsTogetherInEveryClip) {
  const Model& model = checks::character(GetParam());
  for (const Clip& clip : model.clips) {
    for (int instant = 0; instant <= 6; ++instant) {
      const double time = glm::mix(clip.begin, clip.end, instant / 6.0);
      const checks::Box box = checks::posedBox(model, clip.name, time);
      EXPECT_LT(checks::diagonal(box), 1.5 * model.rest_diagonal) << clip.name << " at " << time;
      EXPECT_GT(checks::diagonal(box), 0.2 * model.rest_diagonal) << clip.name << " at " << time;
      EXPECT_LT(checks::largestStretch(model, clip.name, time, 1e-3 * model.rest_diagonal), 8.0)
          << clip.name << " at " << time;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Names, EveryCharacter, testing::ValuesIn(generatorNames()),
                         [](const auto& character) { return character.param; });

}  // namespace
}  // namespace lithe::bake
