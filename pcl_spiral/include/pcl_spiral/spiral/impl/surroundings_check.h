// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A finished spiral among what stands around the part.
 */
#pragma once

#include <pcl_spiral/collision/surroundings.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_report.h>

#include <vector>

namespace pcl_spiral {

/** \p around, with the other parts of the scan that \p surface leaves out, and the clusters that the ball rides over. */
Surroundings withSurface(Surroundings around, const Surface& surface);

/** Makes a hole of the part of each of \p loops that counts as a gap in the data, but in which \p around has points: the scan shows
 *  something there, and it is not to be cut. */
void gapsToHoles(const Surroundings& around, std::vector<BoundaryLoop>& loops);

/** checkWay of \p path, whose \p report has spacing and noise. */
Status checkSurroundings(const SpiralPath& path, const SpiralSettings& settings, const Surroundings& around, SpiralReport& report);

} // namespace pcl_spiral
