// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Moves a path towards places where it would leave higher ridges than allowed.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

namespace pcl_spiral {

/** What coverPath found, and what is left. */
struct CoverReport {
  std::size_t places = 0;                       ///< test points farther than half a step-over from the path before it was moved
  std::size_t left = 0;                         ///< and afterwards
  double farthest_before = 0.0, farthest = 0.0; ///< distance from the path, step-overs; half a step-over leaves the scallop height
  Eigen::Vector3d farthest_place = Eigen::Vector3d::Zero();
  int rounds = 0;
};

/** Move \p path towards places more than half a step-over from it: on and beside the ridges of \p field, in fingers,
 *  between ramps and bridges, and where the field is not a true distance. Each such place moves the nearest part of the path
 *  by the excess, which fades out over 0.8 step-overs to either side; at most 24 rounds. The first \p held step-overs of the
 *  path, on the rim, do not move. \return false when cancelled. */
bool coverPath(const StepOverDistance& field, double held, const ProgressCallback& progress, LinkedPath& path, CoverReport& figures);

} // namespace pcl_spiral
