// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Judges a path by the points of the scan alone.
 */
#pragma once

#include "refused_input.h"

#include <string>

namespace pcl_spiral::followed {

/** What is wrong with the path in \p file for a ball of \p radius, mm: the deepest cut into a point of the scan that is more than noise
 *  and the chord error allow. Points with hardly a neighbour are false echoes. Empty: nothing. */
std::string faultOfPath(const RefusedInput& input, double radius, const std::string& file);

} // namespace pcl_spiral::followed
