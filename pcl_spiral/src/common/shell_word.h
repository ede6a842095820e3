// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Names of files in commands that a user copies.
 */
#pragma once

#include <string>

namespace pcl_spiral {

/** \p text as one word for a POSIX shell: in single quotes if it holds special characters. */
std::string shellWord(const std::string& text);

/** The name of a file as one word; a name that begins like an option gets the folder before it. */
std::string shellFile(const std::string& file);

} // namespace pcl_spiral
