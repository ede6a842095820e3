// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a cutter touches a quadratic height model.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

#include <Eigen/Core>

namespace pcl_spiral {

/** Heights along the tool axis over the plane across it: height + slope d + d' bend d / 2 with d = x - at; x is
 * measured from the axis. */
struct HeightModel {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double height = 0.0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  Eigen::Matrix2d bend = Eigen::Matrix2d::Zero();

  double value(const Eigen::Vector2d& x) const
  {
    const Eigen::Vector2d d = x - at;
    return height + slope.dot(d) + 0.5 * d.dot(bend * d);
  }
};

/** The radius p at which z(p) + (p - q)^2 / (2 c) is least, z the profile, q >= 0 and c > 0; \p derivative is
 * dp / dq. At p the slope of the profile is (q - p) / c; at an edge, this value lies between the slopes on
 * either side. It holds for flat, corner (sharp or not), flank and top edge. */
double proximalRadius(const CutterProfile& profile, double q, double c, double& derivative);

/** The place x, within R of the axis, where the cutter first touches the model as it comes down: the maximum of
 *  value(x) - z(|x|), started from model.at.
 *
 *  Fixed point of x = prox(x + c grad value(x)), by Newton's method: this equation is smooth where the cutter
 * has edges. If a Newton step brings no progress, the step is the prox itself, which always climbs. Source of
 * the equation: Parikh, Boyd, Proximal algorithms, 2014, section 4.2. */
Eigen::Vector2d touchModel(const CutterProfile& profile, const HeightModel& model);

} // namespace pcl_spiral
