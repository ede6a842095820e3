// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Coordinates that are angles on the earth.
 */
#pragma once

#include "point_table.h"

#include <string>

namespace pcl_spiral {

/** Whether x and y can be longitude and latitude in degrees: all within 180 and 90, and within a few degrees of each other. */
bool canBeDegrees(const PointTable& table);

/** Whether x and y are nearly surely degrees: they can be, and the points are far from 0 and a thousand times as high as wide. A height of
 *  1 % of the width, in metres, is 1100 times the width in degrees. */
bool looksLikeDegrees(const PointTable& table);

/** "are degrees: reproject them to metres", with the command if \p file is a .las; \p named: the file names its coordinate system. */
std::string degreesRemedy(const std::string& file, const PointTable& table, bool named);

} // namespace pcl_spiral
