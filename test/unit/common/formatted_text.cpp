// SPDX-License-Identifier: BSD-3-Clause
#include "common/formatted_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace formatted_text_test {

using namespace pcl_spiral;

TEST(FormattedText, WritesAsPrintfDoes)
{
  EXPECT_EQ(formatted("%s %.3g mm, %zu points, %+.1f %%", "chord", 0.12345, std::size_t{7}, -2.25), "chord 0.123 mm, 7 points, -2.2 %");
  EXPECT_EQ(formatted("%s", ""), "");
}

TEST(FormattedText, IsNeverCutOff)
{
  const std::string words(5000, 'x');
  EXPECT_EQ(formatted("<%s>", words.c_str()), "<" + words + ">");
  EXPECT_EQ(formatted("%.3f", std::numeric_limits<double>::max()).size(), 309u + 4u);
}

} // namespace formatted_text_test
