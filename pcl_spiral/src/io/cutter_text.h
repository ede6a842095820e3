// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A cutter in words.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

#include <string>

namespace pcl_spiral {

/** "radius 6 mm, corner 1 mm, flank 20 mm long, 5 degrees to the axis"; "radius 6 mm, a ball" */
std::string cutterText(const CutterShape& cutter);

} // namespace pcl_spiral
