// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The encoding of text files.
 */
#pragma once

#include <string>
#include <string_view>

namespace pcl_spiral {

/** \p bytes is the content of \p file, which should be text in UTF-8 or ASCII, or begin with such text.
 *  \throw FileError with the command that converts text in UTF-16 or UTF-32 */
void refuseWideText(const std::string& file, std::string_view bytes);

} // namespace pcl_spiral
