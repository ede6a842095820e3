// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Trims the ends of passes that cross themselves.
 */
#pragma once

#include <pcl_spiral/spiral/loop_linking.h>

namespace pcl_spiral {

/** If one of the last moves of a pass of \p path, within five step-overs of its end, crosses another move of the pass, the pass ends
 *  0.12 step-overs before the crossing. Later passes are cut in the same way at their begin; the first begins on the rim. */
void trimEnd(LinkedPath& path);

} // namespace pcl_spiral
