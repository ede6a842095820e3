// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reads base64.
 */
#pragma once

#include <string>

namespace pcl_spiral::test {

/** The bytes of \p base64, up to the first character that is not one of it. */
inline std::string
decoded(const std::string& base64)
{
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned int bits = 0;
  int count = 0;
  for (const char c : base64) {
    const std::size_t value = letters.find(c);
    if (value == std::string::npos)
      break;
    bits = bits << 6 | static_cast<unsigned int>(value);
    count += 6;
    if (count >= 8)
      bytes += static_cast<char>(bits >> (count -= 8) & 0xFF);
  }
  return bytes;
}

} // namespace pcl_spiral::test
