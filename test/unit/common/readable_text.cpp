// SPDX-License-Identifier: BSD-3-Clause
// Bytes that are not text are replaced one by one; text does not change (RFC 3629, and the characters of
// XML 1.0).
#include "common/readable_text.h"

#include <gtest/gtest.h>

namespace readable_text_test {

using pcl_spiral::readableText;

TEST(ReadableText, WellFormedTextStays)
{
  for (const char* text : {"", "part.xyz", "a\tb\nc", "\x7F", "\xC2\x80", "K\xC3\xBChler", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF",
                           "\xEE\x80\x80", "\xEF\xBF\xBD", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBD"})
    EXPECT_EQ(readableText(text), text);
}

TEST(ReadableText, EveryByteThatBelongsToNoCharacterIsReplaced)
{
  EXPECT_EQ(readableText("sc\xFF\xC3\x01n.xyz", "?"), "sc???n.xyz");
  EXPECT_EQ(readableText("a\xFFz"), "a\xEF\xBF\xBDz");
  EXPECT_EQ(readableText("\x80", "?"), "?") << "goes on from nothing";
  EXPECT_EQ(readableText("\xE2\x82", "?"), "??") << "ends too soon";
  EXPECT_EQ(readableText("\xE2\x82x", "?"), "??x");
  EXPECT_EQ(readableText("\xC3\xC3\xA4", "?"), "?\xC3\xA4") << "a character begins within another";
  EXPECT_EQ(readableText("\xC0\xAF", "?"), "??") << "longer than need be";
  EXPECT_EQ(readableText("\xE0\x9F\xBF", "?"), "???") << "longer than need be";
  EXPECT_EQ(readableText("\xF0\x8F\xBF\xBD", "?"), "????") << "longer than need be";
  EXPECT_EQ(readableText("\xED\xA0\x80", "?"), "???") << "half a pair of UTF-16";
  EXPECT_EQ(readableText("\xF4\x90\x80\x80", "?"), "????") << "beyond U+10FFFF";
  EXPECT_EQ(readableText("\xEF\xBF\xBF", "?"), "???") << "no character";
  EXPECT_EQ(readableText(std::string("a\0\x1F\r", 4), "?"), "a???") << "XML knows none of these";
}

} // namespace readable_text_test
