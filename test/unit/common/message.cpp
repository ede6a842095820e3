// SPDX-License-Identifier: BSD-3-Clause
// Numbers and places in messages are easy to read.
#include <pcl_spiral/common/impl/message.h>

#include <gtest/gtest.h>

namespace message_test {

using pcl_spiral::placeText;
using pcl_spiral::textOf;

TEST(Message, RealNumbersHaveFourDigitsAndLengthsOfKilometresAllTheirMillimetres)
{
  EXPECT_EQ(textOf(0.0123456, " mm"), "0.01235 mm");
  EXPECT_EQ(textOf(10.0), "10");
  EXPECT_EQ(textOf(9999.4), "9999");
  EXPECT_EQ(textOf(10367.5, " mm long"), "10368 mm long");
  EXPECT_EQ(textOf(-13552272.4), "-13552272");
  EXPECT_EQ(textOf(2.5e-7), "2.5e-07");
  EXPECT_EQ(textOf(1234567u, " of ", std::size_t{20000000}), "1234567 of 20000000");
}

TEST(Message, PlacesAreGivenToTheThousandth)
{
  EXPECT_EQ(placeText({12.5, -3.0, 0.1251}), "(12.5, -3, 0.125)");
  EXPECT_EQ(placeText({-0.0001, 100.0, 8.45e5}), "(0, 100, 845000)");
}

} // namespace message_test
