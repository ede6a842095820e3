// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Text with numbers in a given form. Private.
 */
#pragma once

#include <string>

namespace pcl_spiral {

/** The text that printf would write, of any length. */
std::string formatted(const char* format, ...) __attribute__((format(printf, 1, 2)));

} // namespace pcl_spiral
