// SPDX-FileCopyrightText: 2026 the lithe authors
// SPDX-License-Identifier: MIT
// Every numbered reader check of docs/format.md has a test in this program whose name begins with its number.
#include <gtest/gtest.h>

#include <set>

#include "spec_tables.h"

namespace lithe::test {
namespace {

/// The numbers of the tests of a suite: 17 of N17_SceneNode.
std::set<uint32_t> numbersOfSuite(const std::string& name) {
  std::set<uint32_t> numbers;
  const testing::UnitTest& program = *testing::UnitTest::GetInstance();
  for (int s = 0; s < program.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *program.GetTestSuite(s);
    if (std::string(suite.name()) != name) continue;
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const std::string test = suite.GetTestInfo(t)->name();
      if (test[0] == 'N' && std::isdigit(static_cast<unsigned char>(test[1])))
        numbers.insert(static_cast<uint32_t>(std::stoul(test.substr(1))));
    }
  }
  return numbers;
}

TEST(Checks, EveryNumberOfTheSpecificationHasATest) {
  const Specification specification(LITHE_SOURCE_DIR "/docs/format.md");
  std::set<uint32_t> listed, tested = numbersOfSuite("HeadCheck");
  for (const uint32_t number : tested) EXPECT_LT(number, 60u) << "checks of pages are tested in PageCheck";
  for (const SpecRow& row : specification.table("Reader checks"))
    EXPECT_TRUE(listed.insert(static_cast<uint32_t>(std::stoul(row[0]))).second) << row[0] << " occurs twice";
  EXPECT_GT(listed.size(), 40u);
  tested.merge(numbersOfSuite("PageCheck"));
  for (const uint32_t number : listed) EXPECT_TRUE(tested.count(number)) << "check " << number << " has no test";
  for (const uint32_t number : tested)
    EXPECT_TRUE(listed.count(number)) << "the specification lists no check " << number;
}

}  // namespace
}  // namespace lithe::test
