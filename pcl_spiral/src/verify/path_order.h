// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether the points of a path come in its order. Private to verify.
 */
#pragma once

#include <pcl_spiral/verify/impl/cutter_path.h>

namespace pcl_spiral {

/** Fails if the points are in no order, as in a table that was sorted anew: then the moves are far longer than rows as close as the points
 *  can be. Every move would pass everywhere, and measuring would take hours. */
Status checkOrder(const CutterPath& path);

} // namespace pcl_spiral
