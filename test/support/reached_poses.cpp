// SPDX-License-Identifier: BSD-3-Clause
#include "support/reached_poses.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl_spiral::test {
namespace {

constexpr double in_degrees = 180.0 / M_PI;

/** Distance of the tip in mm, and of the axis in degrees. */
std::array<double, 2>
off(const ControlMotion& motion, const ToolPose& pose)
{
  const double angle = std::atan2(motion.at.axis.cross(pose.axis).norm(), motion.at.axis.dot(pose.axis));
  return {(motion.at.tip - pose.tip).norm(), angle * in_degrees};
}

/** Distance of the ball's centre of \p pose from its way in \p run, from motion \p at on. */
double
offBall(const ControlRun& run, std::size_t at, const ToolPose& pose, double radius)
{
  const auto centre = [&](std::size_t i) -> Eigen::Vector3d { return run.motions[i].at.tip + radius * run.motions[i].at.axis; };
  const Eigen::Vector3d wanted = pose.tip + radius * pose.axis;
  double least = INFINITY;
  for (std::size_t i = std::max<std::size_t>(at, 1); i < run.motions.size(); ++i) {
    const Eigen::Vector3d from = centre(i - 1), way = centre(i) - from;
    const double t = way.squaredNorm() > 0.0 ? std::clamp((wanted - from).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0.0;
    least = std::min(least, (from + t * way - wanted).norm());
  }
  return least;
}

std::string
howFar(const ControlRun& run, std::size_t at, const ToolPose& pose)
{
  const ControlMotion* nearest = nullptr;
  double least = INFINITY;
  for (std::size_t i = at; i < run.motions.size(); ++i)
    if (const auto by = off(run.motions[i], pose); by[0] + by[1] < least) {
      least = by[0] + by[1];
      nearest = &run.motions[i];
    }
  if (nearest == nullptr)
    return "no motion is left";
  std::ostringstream text;
  text << "at line " << nearest->line << " the tip is off by " << off(*nearest, pose)[0] << " mm, "
       << (nearest->at.tip - pose.tip).dot(pose.axis) << " along the tool, and the axis by " << off(*nearest, pose)[1] << " degrees";
  return text.str();
}

} // namespace

std::string
missedPose(const ControlRun& run, const PosesToReach& path)
{
  std::size_t at = 0;
  for (std::size_t pass = 0; pass < path.passes.size(); ++pass)
    for (std::size_t i = 0; i < path.passes[pass].size(); ++i) {
      const ToolPose& pose = path.passes[pass][i];
      const auto missed = [&](const std::string& how) {
        return "pose " + std::to_string(i) + " of pass " + std::to_string(pass) + " is missed: " + how;
      };
      if (pass == 0 && std::any_of(path.zones.begin(), path.zones.end(),
                                   [i](const PoleZone& zone) { return i >= zone.first_pose && i <= zone.last_pose; })) {
        if (const double by = offBall(run, at, pose, path.ball_radius); by > 0.005)
          return missed("the ball is off by " + std::to_string(by) + " mm");
        continue;
      }
      std::size_t found = at;
      const auto isAt = [&](const ControlMotion& motion) {
        const auto by = off(motion, pose);
        return !motion.rapid && by[0] < 1e-3 && by[1] < 1e-3;
      };
      while (found < run.motions.size() && !isAt(run.motions[found]))
        ++found;
      if (found == run.motions.size())
        return missed(howFar(run, at, pose));
      at = found;
    }
  return {};
}

std::string
missedBlock(const ControlRun& run, const MachineProgram& program)
{
  std::size_t at = 0;
  for (std::size_t i = 0; i < program.blocks.size(); ++i) {
    const ProgramBlock& block = program.blocks[i];
    const Eigen::Vector3d gauge = block.machine + program.machine.work_zero + Eigen::Vector3d(0.0, 0.0, program.machine.tool_length);
    const auto isAt = [&](const ControlMotion& motion) {
      return (motion.gauge - gauge).norm() < 0.02 && std::abs(motion.degrees[0] - block.angles.first * in_degrees) < 2e-3 &&
             std::abs(motion.degrees[1] - block.angles.second * in_degrees) < 2e-3;
    };
    std::size_t found = at;
    while (found < run.motions.size() && !isAt(run.motions[found]))
      ++found;
    if (found == run.motions.size()) {
      std::ostringstream text;
      text << "the machine does not come to block " << i << " at " << gauge.transpose() << ", " << block.angles.first * in_degrees << ", "
           << block.angles.second * in_degrees;
      if (at < run.motions.size())
        text << " after line " << run.motions[at].line << " at " << run.motions[at].gauge.transpose() << ", " << run.motions[at].degrees[0]
             << ", " << run.motions[at].degrees[1];
      return text.str();
    }
    at = found;
  }
  return {};
}

} // namespace pcl_spiral::test
