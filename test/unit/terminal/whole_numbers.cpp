// SPDX-License-Identifier: BSD-3-Clause
// A whole number that is out of range is refused with the range.
#include "toolpath/command_line.h"

#include <gtest/gtest.h>

#include <string>

namespace whole_numbers_test {

std::string
saidOf(const char* option, const char* value)
{
  const char* arguments[] = {"pcl_spiral_toolpath", "scan.xyz", "-o", "path.csv", "--tool-radius", "5", "--scallop", "0.1", option, value};
  try {
    parseCommandLine(static_cast<int>(std::size(arguments)), arguments);
  }
  catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST(WholeNumbers, OneOutOfRangeIsRefusedWithTheRange)
{
  for (const char* value : {"-1", "3000000000", "1e300"}) {
    const std::string said = saidOf("--remedy-tries", value);
    EXPECT_NE(said.find("must be from 0 to 1000000000 paths"), std::string::npos) << said;
  }
  EXPECT_NE(saidOf("--skip-lines", "3000000000").find("must be from -1000000000 to 1000000000"), std::string::npos)
      << saidOf("--skip-lines", "3000000000");
  EXPECT_NE(saidOf("--remedy-tries", "2.5").find("not a whole number"), std::string::npos);
  EXPECT_EQ(saidOf("--remedy-tries", "1000000000"), "");
}

} // namespace whole_numbers_test
