// SPDX-License-Identifier: BSD-3-Clause
#include "pass_axes.h"
#include "terminal/terminal.h"

#include "core/smooth_axes.h"
#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>

using namespace pcl_spiral;

namespace {

/** A pass as its points and axes; a ring three times round, so that its middle knows no ends. */
void
unroll(const DrivePass& pass, Polyline& points, std::vector<Eigen::Vector3d>& axes)
{
  for (int round = 0; round < (pass.closed ? 3 : 1); ++round)
    for (const DrivePoint& p : pass.points) {
      points.push_back(p.position);
      axes.push_back(p.axis.normalized());
    }
}

} // namespace

void
smoothPasses(const PassJob& job, DrivePasses& passes, std::vector<std::string>& warnings)
{
  if (!(job.axis_smoothing > 0.0 || job.max_axis_rate > 0.0))
    return;
  constexpr double most_smoothed = 20.0, farthest = 45.0; // degrees; farther off, passes no longer cover the surface
  AxisFieldOptions options;
  options.smoothing_length = job.axis_smoothing;
  options.max_deviation = most_smoothed * degree;
  options.max_rate = job.max_axis_rate * degree;
  double largest = 0.0;
  for (DrivePass& pass : passes) {
    Polyline points;
    std::vector<Eigen::Vector3d> axes;
    unroll(pass, points, axes);
    const SmoothAxes smoothed = smoothAxes(points, axes, options);
    const std::size_t first = pass.closed ? pass.points.size() : 0;
    for (std::size_t i = 0; i < pass.points.size(); ++i)
      pass.points[i].axis = smoothed.axes[first + i];
    largest = std::max(largest, smoothed.largest_deviation / degree);
  }
  if (largest > farthest)
    throw UsageError(textOf("--max-axis-rate ", job.max_axis_rate, ", --axis-smoothing ", job.axis_smoothing, ": axes would lean ", largest,
                            " degrees off those asked for, and not cover the surface; raise "
                            "the rate, or smooth over less"));
  if (largest > 1.0)
    warnings.push_back(textOf("smoothing and rate lead axes up to ", largest, " degrees off those asked for"));
}
