// SPDX-License-Identifier: BSD-3-Clause
#include "machine/motion_track.h"

#include "half_turn.h"
#include <pcl_spiral/machine/impl/sampled_moves.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl_spiral {

MotionTrack::MotionTrack(MachineProgram program, const MotionTime& time, bool axis_arcs)
: program_(std::move(program)), axis_arcs_(axis_arcs), kinematics_{Kinematics(program_.machine)}
{
  double seconds = 0.0, way = 0.0;
  ends_.reserve(program_.blocks.size());
  ways_.reserve(program_.blocks.size());
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    if (i > 0)
      way += (program_.blocks[i].tip - program_.blocks[i - 1].tip).norm();
    seconds += time.blocks[i];
    ends_.push_back(seconds);
    ways_.push_back(way);
  }
}

double
MotionTrack::secondsIn(std::size_t block, double share) const
{
  const double begin = block > 0 ? ends_[block - 1] : 0.0;
  return begin + share * (ends_[block] - begin);
}

double
MotionTrack::secondsAt(double length) const
{
  const auto found = std::lower_bound(ways_.begin(), ways_.end(), length);
  if (found == ways_.end())
    return seconds();
  const auto block = static_cast<std::size_t>(found - ways_.begin());
  const double begin = block > 0 ? ways_[block - 1] : 0.0, way = ways_[block] - begin;
  return secondsIn(block, way > 0.0 ? std::clamp((length - begin) / way, 0.0, 1.0) : 1.0);
}

double
MotionTrack::feedIn(std::size_t block) const
{
  return took(block) > 0.0 ? 60.0 * wayOf(block) / took(block) : 0.0;
}

double
MotionTrack::askedIn(std::size_t block) const
{
  const ProgramBlock& to = program_.blocks[block];
  return !to.rapid && to.minutes > 0.0 ? wayOf(block) / to.minutes : 0.0;
}

/** The rotary axes turn evenly; where the tool axis moves along an arc, as that \p axis needs. */
RotaryAngles
MotionTrack::anglesAt(const ProgramBlock& from, const ProgramBlock& to, double share, const Eigen::Vector3d& axis) const
{
  RotaryAngles even = from.angles;
  even.first += share * (to.angles.first - from.angles.first);
  even.second += share * (to.angles.second - from.angles.second);
  if (!axis_arcs_ || program_.machine.three_axes)
    return even;
  RotaryAngles nearest = even;
  double least = std::numeric_limits<double>::infinity();
  for (const Branch branch : {Branch::Larger, Branch::Smaller}) {
    std::optional<RotaryAngles> found = kinematics_.front().anglesOf(axis, branch);
    if (!found)
      continue;
    found->first = std::isnan(found->first) ? even.first : nearestTurn(found->first, even.first); // at the pole any reaches the axis
    found->second = nearestTurn(found->second, even.second);
    const double off = std::hypot(found->first - even.first, found->second - even.second);
    if (off < least)
      nearest = *found;
    least = std::min(least, off);
  }
  return nearest;
}

MotionFrame
MotionTrack::at(double seconds) const
{
  const auto found = std::upper_bound(ends_.begin(), ends_.end(), seconds);
  MotionFrame frame;
  frame.block = std::min<std::size_t>(static_cast<std::size_t>(found - ends_.begin()), ends_.size() - 1);
  frame.seconds = std::clamp(seconds, 0.0, this->seconds());
  const std::size_t before = frame.block > 0 ? frame.block - 1 : 0;
  const double lasts = took(frame.block);
  frame.share = lasts > 0.0 ? std::clamp((frame.seconds - ends_[before]) / lasts, 0.0, 1.0) : 1.0;
  const ProgramBlock &from = program_.blocks[before], &to = program_.blocks[frame.block];
  const ToolPose pose = poseOnMove(kinematics_.front(), from, to, frame.share, axis_arcs_);
  frame.tip = pose.tip;
  frame.axis = pose.axis;
  frame.angles = anglesAt(from, to, frame.share, pose.axis);
  frame.length = ways_[before] + frame.share * wayOf(frame.block);
  frame.feed = feedIn(frame.block);
  frame.asked = askedIn(frame.block);
  return frame;
}

} // namespace pcl_spiral
