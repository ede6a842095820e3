// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What counts as nothing: for all that plan and all that judge, so that no check is stricter than what made the path.
 */
#pragma once

namespace pcl_spiral {

/** Of single points, in standard deviations: what is within is no cut into the part. Gaussian noise puts one point of 3.5 million farther
 *  to one side. */
constexpr double point_deviations = 5.0;

/** Of the fitted surface (MlsSurface::fitNoise), in standard deviations: a depth below that is not known. Gaussian noise puts one place of
 *  740 farther to one side. */
constexpr double fit_deviations = 3.0;

/** Of the chord error: where a ball is that much off its contact, it still reaches the surface. Moves leave ten times as much. */
constexpr double reach_share = 0.1;

/** Of the chord error: how far a ball keeps from points that it rides over. A straight move between two of its places cuts a corner by the
 *  chord error, over a point that may be as much off the corner. */
constexpr double ride_share = 2.0;

/** How deep a path that touches the scan may be in one of its points, mm: its chord error, and what counts as noise of a point. Of
 *  all checks of a path against points. */
constexpr double
gougeTolerance(double chord_error, double noise)
{
  return chord_error + point_deviations * noise;
}

} // namespace pcl_spiral
