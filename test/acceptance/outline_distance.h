// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far closed lines lie from each other.
 */
#pragma once

#include "support/checked_path.h"

#include <pcl_spiral/core/polyline.h>

namespace pcl_spiral::acceptance {

/** Hausdorff distance between two closed lines: the larger of both directions, and where. Points no farther apart than
 *  \p step are looked at. */
test::Place hausdorff(const Polyline& a, const Polyline& b, double step);

} // namespace pcl_spiral::acceptance
