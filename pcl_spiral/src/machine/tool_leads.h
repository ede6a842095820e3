// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The ways of the tool to a path and away from it.
 */
#pragma once

#include "lead_ways.h"

#include <pcl_spiral/machine/impl/rotary_path.h>
#include <pcl_spiral/machine/machine_program_generator.h>

namespace pcl_spiral {

/** Blocks before and after a cutting run, at the rotary angles of its ends. */
class ToolLeads {
public:
  /** \p top: height above the workpiece zero along \p up that is clear of everything. */
  ToolLeads(const Kinematics& kinematics, const ProgramSettings& settings, const Eigen::Vector3d& up, double top)
  : kinematics_(kinematics), settings_(settings), ways_(settings, up, top)
  {}

  /** From the top down to the path at \p at, which continues along \p travel; the blocks end there. */
  std::vector<ProgramBlock> entry(const MachineLocation& at, const Eigen::Vector3d& travel) const;
  /** From the path at \p at, which ends along \p travel, up to the top. */
  std::vector<ProgramBlock> exit(const MachineLocation& at, const Eigen::Vector3d& travel) const;
  /** At the top above \p at: turns the first angle to \p to in steps. */
  std::vector<ProgramBlock> unwinding(const ProgramBlock& at, double to) const;

private:
  std::vector<ProgramBlock> blocksOf(const std::vector<LeadPlace>& places, const MachineLocation& at) const;
  ToolPose poseOf(const MachineLocation& at) const;

  const Kinematics& kinematics_;
  const ProgramSettings& settings_;
  LeadWays ways_;
};

/** The block to \p tip with the angles of \p at. */
ProgramBlock blockTo(const Kinematics& kinematics, const Eigen::Vector3d& tip, const MachineLocation& at, BlockSection section, bool rapid);

} // namespace pcl_spiral
