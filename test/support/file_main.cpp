// SPDX-License-Identifier: BSD-3-Clause
// The main function of a test program that holds the tests of many files: PROGRAM FILE [options of GoogleTest] runs those of FILE.cpp,
// without a name all. It fails if there is no such file, or if none of its tests would run.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>

namespace {

/** The tests of a file, as a filter; empty if there are none. */
std::string
testsOf(const std::string& file)
{
  std::string filter;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int s = 0; s < all.total_test_suite_count(); ++s) {
    const testing::TestSuite& suite = *all.GetTestSuite(s);
    for (int t = 0; t < suite.total_test_count(); ++t) {
      const testing::TestInfo& test = *suite.GetTestInfo(t);
      if (std::filesystem::path(test.file()).stem() == file && std::string(test.name()).rfind("DISABLED_", 0) != 0)
        filter += (filter.empty() ? "" : ":") + std::string(suite.name()) + "." + test.name();
    }
  }
  return filter;
}

} // namespace

int
main(int argc, char** argv)
{
  // A death test runs this program again, with its own filter.
  const bool dies =
      std::any_of(argv, argv + argc, [](const std::string& word) { return word.rfind("--gtest_internal_run_death_test", 0) == 0; });
  testing::InitGoogleTest(&argc, argv);
  if (argc > 1 && !dies) {
    const std::string filter = testsOf(argv[1]);
    if (filter.empty()) {
      std::cerr << argv[0] << " has no tests of " << argv[1] << ".cpp\n";
      return 1;
    }
    if (testing::GTEST_FLAG(filter) != "*") {
      std::cerr << argv[0] << ": give a file or a filter, not both\n";
      return 1;
    }
    testing::GTEST_FLAG(filter) = filter;
  }
  return RUN_ALL_TESTS();
}
