/** \file
 *  The inner end of a path, where it must not cross itself.
 */
#pragma once

#include <pcl_spiral/spiral/loop_linking.h>

namespace pcl_spiral {

/** Where one of the last moves of \p path, within five step-overs of its end, crosses another, the path ends 0.12 step-overs
 *  before that. */
void
trimEnd(LinkedPath& path);

} // namespace pcl_spiral
