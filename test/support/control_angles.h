// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How a control finds the positions of its axes.
 */
#pragma once

#include "support/machine_oracle.h"

#include <array>

namespace pcl_spiral::test {

/** Gauge point in machine coordinates and unwound angles in degrees. */
struct AxisPosition {
  Eigen::Vector3d gauge = Eigen::Vector3d::Zero();
  std::array<double, 2> degrees{};
};

/** The tool against the workpiece. */
TipAndAxis toolAt(const MachineChain& chain, const AxisPosition& at);

/** The gauge point that brings the tip to \p tip at these angles. */
Eigen::Vector3d gaugeFor(const MachineChain& chain, const Eigen::Vector3d& tip, const std::array<double, 2>& degrees);

/** Angles that bring the tool along \p axis: of both solutions and all turns those with the least turning from
 *  \p from. \throw std::runtime_error the machine cannot reach the axis */
std::array<double, 2> nearestAngles(const MachineChain& chain, const Eigen::Vector3d& axis, const std::array<double, 2>& from);

} // namespace pcl_spiral::test
