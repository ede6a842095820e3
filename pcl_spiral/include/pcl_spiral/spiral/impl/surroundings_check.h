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

/** Those of \p points that do not lie on \p surface beside its own points: more than 12 times its noise off it, as points of a thing
 *  are, or away from all of them. */
std::vector<Eigen::Vector3f> offSurface(const Surface& surface, const std::vector<Eigen::Vector3f>& points);

/** Makes a hole of the part of each of \p loops that counts as a gap in the data, but in which the scan shows something that is not to be
 *  cut: \p around has more points there than a false echo, where a ball of \p radius or its shank can meet them. A warning for each. */
void gapsToHoles(const Surroundings& around, const Surface& surface, double radius, std::vector<BoundaryLoop>& loops,
                 Diagnostics& warnings);

/** checkWay of \p path, whose \p report has spacing and noise. */
Status checkSurroundings(const SpiralPath& path, const SpiralSettings& settings, const Surroundings& around, SpiralReport& report);

} // namespace pcl_spiral
