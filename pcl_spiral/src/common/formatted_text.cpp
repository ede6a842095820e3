// SPDX-License-Identifier: BSD-3-Clause
#include "formatted_text.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace pcl_spiral {

std::string
formatted(const char* format, ...)
{
  va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const int length = std::vsnprintf(nullptr, 0, format, arguments);
  va_end(arguments);
  std::string text(static_cast<std::size_t>(std::max(0, length)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, again);
  va_end(again);
  return text;
}

} // namespace pcl_spiral
