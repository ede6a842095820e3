// SPDX-License-Identifier: BSD-3-Clause
#include "pass_axes.h"

#include "core/smooth_axes.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Axes = std::vector<Eigen::Vector3d>;

constexpr double least_warned = 1.0; // degrees

Status
check(const PassAxisSettings& s)
{
  if (!(s.smoothing_length >= 0.0) || !std::isfinite(s.smoothing_length))
    return {StatusCode::InvalidArgument, Diagnostic("the smoothing length is ", s.smoothing_length,
                                                    " {mm}; set it above 0, or 0 for no smoothing ({PassSettings::axis_smoothing})")};
  if (!(s.max_rate >= 0.0) || !std::isfinite(s.max_rate))
    return {StatusCode::InvalidArgument,
            Diagnostic("the axis rate is ", s.max_rate,
                       " {degrees} per {mm}; set it above 0, or 0 for no limit ({PassSettings::max_axis_rate})")};
  if (!(s.max_deviation > 0.0) || !(s.largest_deviation > 0.0))
    return {StatusCode::InvalidArgument, Diagnostic("the deviations allowed are ", s.max_deviation, " {degrees} on average and ",
                                                    s.largest_deviation, " at a point; set them above 0")};
  return Status::success();
}

/** The axes of a pass, smoothed. A closed pass is taken three times round: the middle one is far from both ends. */
SmoothAxes
smoothed(const DrivePass& pass, const AxisFieldOptions& options)
{
  Polyline points;
  Axes axes;
  for (int round = 0; round < (pass.closed ? 3 : 1); ++round)
    for (const DrivePoint& p : pass.points) {
      points.push_back(p.position);
      axes.push_back(p.axis.normalized());
    }
  SmoothAxes result = smoothAxes(points, axes, options);
  if (pass.closed) {
    const auto size = static_cast<std::ptrdiff_t>(pass.points.size());
    result.axes = Axes(result.axes.begin() + size, result.axes.begin() + 2 * size);
  }
  return result;
}

/** Gives \p p another axis; with a stand-off about the spot of the beam. */
void
turn(DrivePoint& p, const Eigen::Vector3d& axis, const std::optional<double>& stand_off)
{
  if (!stand_off) {
    p.axis = axis;
    return;
  }
  const double reach = beamReach(p, *stand_off);
  const Eigen::Vector3d spot = p.position - reach * p.axis.normalized();
  p.axis = axis;
  p.position = spot + reach * p.axis.normalized();
}

} // namespace

double
beamReach(const DrivePoint& p, double stand_off)
{
  constexpr double least = 1e-3; // cosine: a beam along the surface has no spot
  return stand_off / std::max(least, p.axis.normalized().dot(p.normal));
}

Status
smoothPassAxes(const PassAxisSettings& settings, DrivePasses& passes, PassAxisReport& report)
{
  report = PassAxisReport();
  if (const Status status = check(settings); !status.ok())
    return status;
  if (settings.smoothing_length == 0.0 && settings.max_rate == 0.0)
    return Status::success();
  const AxisFieldOptions options{settings.smoothing_length, settings.max_deviation * degree, settings.max_rate * degree};
  std::vector<Axes> axes;
  for (const DrivePass& pass : passes) {
    SmoothAxes found = smoothed(pass, options);
    report.largest_deviation = std::max(report.largest_deviation, found.largest_deviation / degree);
    axes.push_back(std::move(found.axes));
  }
  if (report.largest_deviation > settings.largest_deviation)
    return {StatusCode::InvalidArgument,
            Diagnostic("at an axis rate of ", settings.max_rate, " {degrees} per {mm} and a smoothing length of ",
                       settings.smoothing_length, " {mm} axes would lean ", report.largest_deviation,
                       " {degrees} from the requested axes and would not cover the surface; raise "
                       "the rate ({PassSettings::max_axis_rate}), or use a shorter smoothing length "
                       "({PassSettings::axis_smoothing})")};
  if (report.largest_deviation > least_warned)
    report.warnings.push_back(
        Diagnostic("smoothing and the rate limit turn axes by up to ", report.largest_deviation, " {degrees} from the requested axes"));
  for (std::size_t k = 0; k < passes.size(); ++k)
    for (std::size_t i = 0; i < passes[k].points.size(); ++i)
      turn(passes[k].points[i], axes[k][i], settings.stand_off);
  return Status::success();
}

} // namespace pcl_spiral
