// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The method for a word on the command line.
 */
#pragma once

#include <pcl_spiral/spiral/spiral_settings.h>

#include <optional>
#include <string>

namespace pcl_spiral::acceptance {

/** The method whose word begins with \p name. */
std::optional<SpiralMethod> methodNamed(const std::string& name);

/** Whether there is one; if not, prints the existing methods. */
bool isMethod(const std::string& name);

} // namespace pcl_spiral::acceptance
