// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How much of a distance is noise, in standard deviations: for all that plan and all that judge, so that no check is stricter than what
 *  made the path.
 */
#pragma once

namespace pcl_spiral {

/** Of single points: what is within is no cut into the part. Gaussian noise puts one point of 3.5 million farther to one side. */
constexpr double point_deviations = 5.0;

/** Of the fitted surface (MlsSurface::fitNoise): a depth below that is not known. Gaussian noise puts one place of 740 farther to one
 *  side. */
constexpr double fit_deviations = 3.0;

} // namespace pcl_spiral
