// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The ways of a tool to its path and off it, in the workpiece frame.
 */
#pragma once

#include <pcl_spiral/machine/machine_program_generator.h>

#include <vector>

namespace pcl_spiral {

/** The end of a move off the path; the tool axis stays. */
struct LeadPlace {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  BlockSection section = BlockSection::Position;
  bool rapid = false;
};

/** Moves before and after a cutting run, at the tool axes of its ends. */
class LeadWays {
public:
  /** \p top: height above the workpiece zero along \p up that is clear of everything. */
  LeadWays(const ProgramSettings& settings, const Eigen::Vector3d& up, double top) : settings_(settings), up_(up), top_(top) {}

  /** From the top down to the path at \p at, which continues along \p travel; the last move ends there. */
  std::vector<LeadPlace> entry(const ToolPose& at, const Eigen::Vector3d& travel) const;
  /** From the path at \p at, which ends along \p travel, up to the top. */
  std::vector<LeadPlace> exit(const ToolPose& at, const Eigen::Vector3d& travel) const;

private:
  std::vector<Eigen::Vector3d> leadTips(const ToolPose& at, const Eigen::Vector3d& inward) const;
  std::vector<Eigen::Vector3d> climb(const Eigen::Vector3d& from, const Eigen::Vector3d& axis) const;

  const ProgramSettings& settings_;
  Eigen::Vector3d up_;
  double top_;
};

} // namespace pcl_spiral
