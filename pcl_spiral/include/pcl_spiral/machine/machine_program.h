// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A path as tool poses, and as the moves of one machine.
 */
#pragma once

#include <pcl_spiral/machine/machine.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** One location of a cutter in the workpiece frame, mm. */
struct ToolPose {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();     ///< of the cutter
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< unit, from the tip to the shank
  Eigen::Vector3d contact = Eigen::Vector3d::Zero(); ///< on the surface
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< unit, out of the material at the contact
};

using ToolPoses = std::vector<ToolPose>; ///< Poses of one pass, in travel order.

/** How far a block may move the tool off the path. */
struct BlockTolerance {
  static constexpr double least_tip = 1e-4;  ///< mm: a smaller tip tolerance would need blocks without end
  static constexpr double least_axis = 1e-6; ///< radians: the same for the axis
  double tip = 0.002;                        ///< mm
  double axis = 0.001;                       ///< radians
};

/** Purpose of a block. */
enum class BlockSection {
  Start,    ///< over the first point at Machine::retract_z, with the rotary axes at their first angles
  Position, ///< above the start, above everything
  Approach, ///< down to where the feed begins
  LeadIn,   ///< from there to the surface
  Cut,      ///< along the path
  Link,     ///< over the surface to the next pass, without a lift
  LeadOut,  ///< off the surface
  Retract,  ///< up again
  Unwind,   ///< the first rotary axis turns back at the top
  End       ///< up to Machine::retract_z
};

/** One linear move of all five axes to this position. */
struct ProgramBlock {
  BlockSection section = BlockSection::Cut;          ///< purpose of the move
  bool rapid = false;                                ///< at rapid speed, without feed
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();     ///< in the workpiece frame, mm
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();   ///< in the workpiece frame, unit
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< of the surface at the contact, unit
  Eigen::Vector3d machine = Eigen::Vector3d::Zero(); ///< X, Y, Z as programmed without RTCP, mm
  RotaryAngles angles;                               ///< radians
  double arc_length = 0.0;                           ///< of the contacts up to here, mm
  double minutes = 0.0;                              ///< time of the move; 0 for rapids
  std::size_t pass = 0;                              ///< the pass that it belongs to, or leads to
};

/** A run of locations near the pole, whose axes were blended so that the first rotary axis keeps to its largest rate. */
struct PoleZone {
  std::size_t first_pose = 0;  ///< of the input path
  std::size_t last_pose = 0;   ///< of the input path
  double begin = 0.0;          ///< arc length, mm
  double end = 0.0;            ///< arc length, mm
  double largest_change = 0.0; ///< of an axis, radians
};

/** Report of a program. Lengths in mm, angles in radians. */
struct ProgramReport {
  Branch branch = Branch::Larger;     ///< used by the whole path
  std::vector<PoleZone> poles;        ///< where axes were blended
  std::size_t cut_blocks = 0;         ///< blocks that cut
  std::size_t split_blocks = 0;       ///< added so that the machine stays near the path
  std::size_t thinned_poses = 0;      ///< left out
  std::size_t slowed_blocks = 0;      ///< whose contact is below the feed: by an axis at its largest rate, or by the tool
  std::size_t tool_slowed_blocks = 0; ///< of these, by the tool: its tip or the centre of its ball is at twice the feed
  double least_feed_share = 1.0;      ///< of the feed, in the block that an axis slows most
  double least_feed_at = 0.0;         ///< arc length at that block
  std::vector<double> unwound_at;     ///< arc lengths where the first axis turns back
  std::size_t links = 0;              ///< passes to which the tool comes by a link near the surface
  std::size_t blocked_links = 0;      ///< passes of setRetractedPasses, to which it comes from above
  double saved_way = 0.0;             ///< of the tip, by links instead of retracts, mm
  double saved_minutes = 0.0;         ///< by links instead of retracts, with rapids at the largest rates of the axes
  double first_travel = 0.0;          ///< sum of all turning of the first rotary axis while cutting
  double lowest_first = 0.0;          ///< angle of the first rotary axis
  double highest_first = 0.0;         ///< angle of the first rotary axis
  double lowest_second = 0.0;         ///< angle of the second rotary axis
  double highest_second = 0.0;        ///< angle of the second rotary axis
  double largest_turn = 0.0;          ///< of a rotary axis in one cutting block
  double minutes = 0.0;               ///< without rapids
};

/** Moves in order, and their machine. */
struct MachineProgram {
  Machine machine;                  ///< that runs it
  double feed = 0.0;                ///< at the contact, mm/min
  std::vector<ProgramBlock> blocks; ///< in order
  ProgramReport report;             ///< of its making
};

} // namespace pcl_spiral
