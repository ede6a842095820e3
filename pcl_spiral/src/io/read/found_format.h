// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The format of a file: by its name, else by its content.
 */
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pcl_spiral {

/** Whether the name of \p file says nothing of its format, as that of a pipe or of /dev/stdin. */
bool isNameless(const std::string& file);

/** The extension of \p file if it is one of \p known; that of a nameless file by its content, \p bytes. \throw FileError if the content is
 *  of no known format */
std::string formatOf(const std::string& file, std::string_view bytes, const std::vector<std::string>& known);

} // namespace pcl_spiral
