// SPDX-License-Identifier: BSD-3-Clause
#include "turn_time.h"

#include "motion_timer.h"
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr std::size_t run_up = 200; ///< blocks on either side: more than the look-ahead

/** Blocks along arcs, one after the other. */
class ArcPath {
public:
  explicit ArcPath(const TurnPace& pace) : pace_(pace)
  {
    axes_.velocity.setConstant(std::numeric_limits<double>::infinity());
    axes_.jerk = axes_.velocity;
    axes_.acceleration.setConstant(pace.acceleration);
  }

  double block(double radius) const { return std::min(pace_.longest, std::sqrt(8.0 * radius * pace_.chord_error)); }

  void add(double radius, std::size_t blocks, double length)
  {
    for (std::size_t i = 0; i < blocks; ++i) {
      heading_ += length / radius;
      AxisValues way = AxisValues::Zero();
      way[0] = length * std::cos(heading_);
      way[1] = length * std::sin(heading_);
      moves_.push_back(controlMove(way, length, pace_.feed, axes_));
      length_ += length;
    }
  }

  double length() const { return length_; }

  std::vector<double> ends() const { return MotionTimer(controlModel(ControlKind::LinuxCNC), axes_, pace_.chord_error).ends(moves_); }

private:
  const TurnPace& pace_;
  AxisDynamics axes_;
  std::vector<ControlMove> moves_;
  double heading_ = 0.0, length_ = 0.0;
};

} // namespace

double
roundTime(const TurnPace& pace, double radius)
{
  ArcPath path(pace);
  const double length = path.block(radius);
  path.add(radius, 3 * run_up, length);
  const std::vector<double> ends = path.ends();
  return (ends[2 * run_up] - ends[run_up]) / (run_up * length);
}

double
bendTime(const TurnPace& pace, double radius, double round)
{
  ArcPath bent(pace), whole(pace);
  const double length = bent.block(round), way = 0.5 * pi * radius;
  const auto blocks = static_cast<std::size_t>(std::ceil(way / std::min(length, bent.block(radius))));
  bent.add(round, run_up, length);
  bent.add(radius, blocks, way / static_cast<double>(blocks));
  bent.add(round, run_up, length);
  whole.add(round, 2 * run_up, length);
  return bent.ends().back() - whole.ends().back() - way * roundTime(pace, round);
}

} // namespace pcl_spiral
