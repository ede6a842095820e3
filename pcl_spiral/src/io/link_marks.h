// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Comments before and after a link between passes: the feed moves between them are not cuts.
 */
#pragma once

#include <string_view>

namespace pcl_spiral {

inline constexpr std::string_view link_begin = "link to the next pass";
inline constexpr std::string_view link_end = "end of the link";

/** Whether a move after \p comment is on a link, if the move before is so or not. */
inline bool
isInLink(std::string_view comment, bool before)
{
  return comment == link_begin || (before && comment != link_end);
}

} // namespace pcl_spiral
