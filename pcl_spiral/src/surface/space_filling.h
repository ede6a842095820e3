// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether points fill space rather than lie on a surface. Private.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/surface/surface.h>

namespace pcl_spiral {

/** Refuses points that fill space, such as noise far above their spacing, trees or random points, before anything is computed for all of
 *  them: each further stage would take minutes before it refuses them.
 *
 *  It looks at some hundreds of points, with settings.part_at at those about that place. A point fills space if its nearest 32, 64, 128
 *  and 256 points all are at least two fifths as thick as they are wide. A surface with a noise of one and a half spacings is not, and
 *  neither is a wire. It refuses if half of the points looked at do, with settings.largest_part if nearly all do. Clouds of less than
 *  10,000 points pass. */
Status checkFillsSpace(const PointBlocks& blocks, const SurfaceSettings& settings);

} // namespace pcl_spiral
