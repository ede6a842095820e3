// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The exact surface behind the mesh of a bonnet; that of the landform is in surfaces.h. Lengths in mm.
 */
#pragma once

#include "support/surfaces.h"

namespace pcl_spiral::test {

/** A bonnet of 1400 x 1000:
 *  z = 90 cos(pi (x - 700) / 2400) cos(pi (y - 500) / 1900) + 7 exp(-((|y - 500| - 260 - (x - 700) / 20) / 45)^2)
 *    + 4 exp(-((x - 400) / 60)^2 - ((y - 500) / 300)^4). */
SurfacePtr bonnet();

} // namespace pcl_spiral::test
