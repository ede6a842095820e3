// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/machine/impl/sampled_moves.h>

#include <pcl_spiral/machine/impl/block_spacing.h>

#include "core/angle_between.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int most_move_halvings = 16;
constexpr double most_turn = 0.1; // radians

class Sampler {
public:
  Sampler(const Kinematics& kinematics, const ProgramBlock& from, const ProgramBlock& to, const MoveSampling& sampling)
  : kinematics_(kinematics), sampling_(sampling), from_(from), to_(to),
    turn_(sampling.axis_arcs ? angleBetween(from.axis, to.axis)
                             : std::max(std::abs(to.angles.first - from.angles.first), std::abs(to.angles.second - from.angles.second)))
  {}

  ToolPose at(double t) const { return poseOnMove(kinematics_, from_, to_, t, sampling_.axis_arcs); }

  /** Adds the poses after share \p a, up to share \p b. */
  void sample(double a, const ToolPose& at_a, double b, const ToolPose& at_b, int halvings, ToolPoses& poses) const
  {
    const double middle = 0.5 * (a + b);
    if (halvings < most_move_halvings && ((b - a) * turn_ > most_turn || !isStraight(a, at_a, b, at_b))) {
      const ToolPose at_middle = at(middle);
      sample(a, at_a, middle, at_middle, halvings + 1, poses);
      sample(middle, at_middle, b, at_b, halvings + 1, poses);
      return;
    }
    poses.push_back(at_b);
  }

private:
  bool isStraight(double a, const ToolPose& at_a, double b, const ToolPose& at_b) const
  {
    return isStraight(sampling_.arm, a, at_a, b, at_b) && (!sampling_.tip_too || isStraight(0.0, a, at_a, b, at_b));
  }

  bool isStraight(double arm, double a, const ToolPose& at_a, double b, const ToolPose& at_b) const
  {
    const auto end = [arm](const ToolPose& pose) -> Eigen::Vector3d { return pose.tip + arm * pose.axis; };
    const Eigen::Vector3d begin = end(at_a), way = end(at_b) - begin;
    const double length = way.squaredNorm();
    for (double f : {0.25, 0.5, 0.75}) {
      const Eigen::Vector3d off = end(at(a + f * (b - a))) - begin;
      const double along = length > 0.0 ? std::clamp(off.dot(way) / length, 0.0, 1.0) : 0.0;
      if ((off - along * way).norm() > sampling_.tolerance)
        return false;
    }
    return true;
  }

  const Kinematics& kinematics_;
  const MoveSampling& sampling_;
  const ProgramBlock &from_, &to_;
  double turn_;
};

} // namespace

ToolPose
poseOf(const ProgramBlock& block)
{
  return {block.tip, block.axis, block.tip, block.normal};
}

ToolPose
poseOnMove(const Kinematics& kinematics, const ProgramBlock& from, const ProgramBlock& to, double t, bool axis_arcs)
{
  return axis_arcs ? between(poseOf(from), poseOf(to), t)
                   : interpolated(kinematics, {poseOf(from), from.angles, 0.0}, {poseOf(to), to.angles, 0.0}, t);
}

ToolPoses
sampledMove(const Kinematics& kinematics, const ProgramBlock& from, const ProgramBlock& to, const MoveSampling& sampling)
{
  const Sampler sampler(kinematics, from, to, sampling);
  ToolPoses poses;
  sampler.sample(0.0, sampler.at(0.0), 1.0, sampler.at(1.0), 0, poses);
  return poses;
}

} // namespace pcl_spiral
