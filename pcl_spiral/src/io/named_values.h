// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Names in braces in the lines of a shop.
 */
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace pcl_spiral {

/** The names that a line may hold, see ShopLines. */
inline constexpr std::array<std::string_view, 7> value_names{"spindle", "tool", "part", "safe_z", "feed", "tolerance", "offset"};

/** A line in pieces: text, and names in braces. \p take(text, is_name) gets them in order; a brace without its partner is text. */
template <typename Take>
void
takePieces(std::string_view line, const Take& take)
{
  while (!line.empty()) {
    const std::size_t open = line.find('{'), close = line.find('}', open == std::string_view::npos ? 0 : open);
    if (open == std::string_view::npos || close == std::string_view::npos) {
      take(line, false);
      return;
    }
    if (open > 0)
      take(line.substr(0, open), false);
    take(line.substr(open + 1, close - open - 1), true);
    line.remove_prefix(close + 1);
  }
}

/** Whether \p written can be \p line with values in the place of its names. */
bool isWrittenLine(std::string_view line, std::string_view written);

} // namespace pcl_spiral
