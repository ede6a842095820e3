// SPDX-License-Identifier: BSD-3-Clause
#include "readable_text.h"

#include <cstdint>

namespace pcl_spiral {
namespace {

/** Length in bytes of the character that begins at \p at: well-formed UTF-8 (RFC 3629) of a character that
 * XML allows; 0 if none begins there. */
std::size_t
characterLength(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t k) {
    return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : static_cast<unsigned char>(0);
  };
  const unsigned char first = byte(0);
  if (first < 0x80)
    return first >= 0x20 || first == '\t' || first == '\n' ? 1 : 0;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  std::uint32_t code = first & (0xFF >> (length + 1));
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0) != 0x80)
      return 0;
    code = code << 6 | (byte(k) & 0x3F);
  }
  const std::uint32_t least = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  return first < 0xC0 || first > 0xF4 || code < least || code > 0x10FFFF || surrogate || (code & 0xFFFE) == 0xFFFE ? 0 : length;
}

} // namespace

std::string
readableText(const std::string& bytes, const std::string& mark)
{
  std::string text;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t length = characterLength(bytes, at);
    text += length > 0 ? bytes.substr(at, length) : mark;
    at += length > 0 ? length : 1;
  }
  return text;
}

} // namespace pcl_spiral
