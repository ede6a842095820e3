// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A path as the moves of one machine.
 */
#pragma once

#include <pcl_spiral/machine/impl/rotary_path.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Purpose of a block. */
enum class BlockSection {
  Position, ///< above the start, above everything
  Approach, ///< down to where the feed begins
  LeadIn,
  Cut,
  LeadOut,
  Retract, ///< up again
  Unwind   ///< the first rotary axis turns back at the top
};

/** One linear move of all five axes to this position. */
struct ProgramBlock {
  BlockSection section = BlockSection::Cut;
  bool rapid = false;
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();     ///< in the workpiece frame, mm
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< in the workpiece frame, unit
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< of the surface at the contact, unit
  Eigen::Vector3d machine = Eigen::Vector3d::Zero(); ///< X, Y, Z as programmed without RTCP, mm
  RotaryAngles angles;                               ///< radians
  double arc_length = 0.0;                           ///< of the contacts up to here, mm
  double minutes = 0.0;                              ///< time of the move; 0 for rapids
};

/** Report of a program. Lengths in mm, angles in radians. */
struct ProgramReport {
  Branch branch = Branch::Larger;
  std::vector<PoleZone> poles;
  std::size_t cut_blocks = 0;
  std::size_t split_blocks = 0;   ///< added so that the machine stays near the path
  std::size_t thinned_poses = 0;  ///< left out
  std::size_t slowed_blocks = 0;  ///< below the feed, so that an axis keeps to its largest rate
  double least_feed_share = 1.0;  ///< of the feed, in the slowest of these blocks
  double least_feed_at = 0.0;     ///< arc length at that block
  std::vector<double> unwound_at; ///< arc lengths where the first axis turns back
  double first_travel = 0.0;      ///< sum of all turning of the first rotary axis while cutting
  double lowest_first = 0.0, highest_first = 0.0;
  double lowest_second = 0.0, highest_second = 0.0;
  double largest_turn = 0.0; ///< of a rotary axis in one cutting block
  double minutes = 0.0;      ///< without rapids
};

/** Moves in order, and their machine. */
struct MachineProgram {
  Machine machine;
  double feed = 0.0; ///< at the contact, mm/min
  std::vector<ProgramBlock> blocks;
  ProgramReport report;
};

} // namespace pcl_spiral
