// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Noise of a scan by few points at a time. Private to planning.
 */
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_spiral {

/** Standard deviation of the points of a scan about its surface, mm, by quadrics through nine of them each; 0 of fewer. Noise is the same
 *  for wide and for narrow fits, and everywhere on a scan, but the shape that a fit misses is neither: so it is told by the narrowest fits,
 *  and by the lower quartile of these. Of a coarse scan, a wide fit takes shape for noise. */
double pointNoise(const std::vector<Eigen::Vector3f>& points);

} // namespace pcl_spiral
