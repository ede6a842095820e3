/** \file
 *  The exact surfaces behind the meshes of the section tests. Lengths in mm.
 */
#pragma once

#include "support/surfaces.h"

namespace pcl_spiral::test {

/** 100 x 100 of rolling ground, slopes up to 25 degrees:
 *  z = 1.6 sin(k60 (x + 0.3 y) + 0.3) + 0.9 sin(k38 (x / 2 + y) + 1.1) + 0.35 sin(k25 (0.6 y - x) + 2), k_w = 2 pi / w. */
SurfacePtr landform();

/** A bonnet of 1400 x 1000:
 *  z = 90 cos(pi (x - 700) / 2400) cos(pi (y - 500) / 1900) + 7 exp(-((|y - 500| - 260 - (x - 700) / 20) / 45)^2)
 *    + 4 exp(-((x - 400) / 60)^2 - ((y - 500) / 300)^4). */
SurfacePtr bonnet();

} // namespace pcl_spiral::test
