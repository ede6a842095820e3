// SPDX-License-Identifier: BSD-3-Clause
#include "shell_word.h"

#include <algorithm>
#include <cctype>

namespace pcl_spiral {

std::string
shellWord(const std::string& text)
{
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return c < 128 && (std::isalnum(c) || std::string("-_./,:=+@%").find(static_cast<char>(c)) != std::string::npos);
  });
  if (plain)
    return text;
  std::string result = "'";
  for (const char c : text)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string
shellFile(const std::string& file)
{
  return shellWord(file.rfind('-', 0) == 0 ? "./" + file : file);
}

} // namespace pcl_spiral
