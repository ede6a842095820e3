// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Bytes that may not be text, such as the name of a file, made into text that can be shown.
 */
#pragma once

#include <string>

namespace pcl_spiral {

/** \p bytes as well-formed UTF-8 (RFC 3629) of characters that XML 1.0 allows: every byte that belongs to no
 * such character is replaced by \p mark, by default U+FFFD, the replacement character. Well-formed text stays
 * as it is. */
std::string readableText(const std::string& bytes, const std::string& mark = "\xEF\xBF\xBD");

} // namespace pcl_spiral
