// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The ends of a path's passes, where they must not cross themselves.
 */
#pragma once

#include <pcl_spiral/spiral/loop_linking.h>

namespace pcl_spiral {

/** Where one of the last moves of a pass of \p path, within five step-overs of its end, crosses another of the pass, this ends 0.12
 *  step-overs before that. Further passes are cut likewise where they begin; the first begins on the rim. */
void trimEnd(LinkedPath& path);

} // namespace pcl_spiral
