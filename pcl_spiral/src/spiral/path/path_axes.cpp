// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/spiral/spiral_path.h>

#include "given_path.h"
#include "shank_room.h"

#include "core/smooth_axes.h"
#include "core/tilted_axes.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace pcl_spiral {
namespace {

double
radians(double degrees)
{
  return degrees * pi / 180.0;
}

double
degrees(double radians)
{
  return radians * 180.0 / pi;
}

/** Call \p visit with contacts and normals of each pass. */
template <typename Visit>
void
forPasses(const SpiralPath& path, Visit visit)
{
  if (path.passes.empty()) // no copies
    return visit(path.onSurface(), path.normals);
  for (const PassRange& pass : passRanges(path.passes, path.contacts.size())) {
    const auto part = [&pass](const std::vector<Eigen::Vector3d>& values) {
      return Polyline(values.begin() + static_cast<std::ptrdiff_t>(pass.begin), values.begin() + static_cast<std::ptrdiff_t>(pass.end));
    };
    visit(part(path.onSurface()), part(path.normals));
  }
}

/** Appends \p pass to \p all; the first is not copied. */
void
append(std::vector<Eigen::Vector3d>&& pass, std::vector<Eigen::Vector3d>& all)
{
  if (all.empty())
    all = std::move(pass);
  else
    all.insert(all.end(), pass.begin(), pass.end());
}

/** Appends the axes of a pass, with the larger of the figures. */
void
append(SmoothAxes&& pass, SmoothAxes& all)
{
  append(std::move(pass.axes), all.axes);
  all.largest_deviation = std::max(all.largest_deviation, pass.largest_deviation);
  all.largest_change = std::max(all.largest_change, pass.largest_change);
  all.largest_rate = std::max(all.largest_rate, pass.largest_rate);
  all.deviating_points += pass.deviating_points;
}

/** Axes of all passes, tilted and smoothed pass by pass; \p wanted: before smoothing. */
SmoothAxes
axesOf(const SpiralPath& path, const SpiralSettings& settings, std::vector<Eigen::Vector3d>& wanted)
{
  const AxisFieldOptions options{settings.axis_smoothing, radians(settings.axis_deviation), radians(settings.max_axis_rate)};
  SmoothAxes all;
  forPasses(path, [&](const Polyline& contacts, const std::vector<Eigen::Vector3d>& normals) {
    auto tilted = tiltedAxes(contacts, normals, radians(settings.tilt_angle), radians(settings.lead_angle));
    append(smoothAxes(contacts, tilted, options), all);
    append(std::move(tilted), wanted);
  });
  return all;
}

/** Leans the tool less where its shank would enter \p obstacles, with a warning. \p field keeps its figures of the deviation. */
void
easeBeside(const std::vector<Eigen::Vector3f>& obstacles, const SpiralPath& path, const SpiralSettings& settings, SmoothAxes& field,
           Diagnostics& warnings)
{
  constexpr double ramp = 2.0, share_of_rate = 0.5; // radii from upright to the whole lean; what it takes of the largest rate
  const double lean = largestLean(path.normals, field.axes).angle, most = radians(settings.max_axis_rate);
  double rate = 1.0 / (ramp * settings.tool_radius);
  if (most > 0.0 && lean > 0.0)
    rate = std::min(rate, share_of_rate * most / lean);
  const std::vector<double> shares = leanShares(path, field.axes, obstacles, settings.tool_radius, rate);
  const auto eased = std::count_if(shares.begin(), shares.end(), [](double share) { return share < 1.0; });
  if (eased == 0)
    return;
  std::vector<Eigen::Vector3d> axes(shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i)
    axes[i] = shares[i] < 1.0 ? leaned(path.normals[i], field.axes[i], shares[i]) : field.axes[i];
  SmoothAxes limited;
  auto begin = axes.begin();
  forPasses(path, [&](const Polyline& contacts, const std::vector<Eigen::Vector3d>&) {
    const auto end = begin + static_cast<std::ptrdiff_t>(contacts.size());
    append(smoothAxes(contacts, {begin, end}, {0.0, radians(settings.axis_deviation), most}), limited);
    begin = end;
  });
  limited.largest_deviation = std::max(limited.largest_deviation, field.largest_deviation);
  limited.deviating_points = field.deviating_points;
  field = std::move(limited);
  const auto least = static_cast<std::size_t>(std::min_element(shares.begin(), shares.end()) - shares.begin());
  warnings.push_back(Diagnostic("beside clusters of points the tool leans less than the set tilt, so that its shank clears them: at ",
                                eased, " of ", shares.size(), " path points, least at ", Place(path.contacts[least]), " in turn ",
                                path.turns[least], ", by ", degrees(std::acos(std::min(1.0, field.axes[least].dot(path.normals[least])))),
                                " {degrees}"));
}

/** The same axis everywhere; a ball touches the surface with its shank where they lie along each other. */
Status
setFixedAxis(const Eigen::Vector3d& axis, SpiralPath& path, AxisReport& figures)
{
  constexpr double flattest = 89.0; // degrees
  const AxisLean lean = largestLean(path.normals, std::vector<Eigen::Vector3d>(path.normals.size(), axis));
  if (degrees(lean.angle) > flattest)
    return {StatusCode::Failed, Diagnostic("the fixed tool axis leans ", degrees(lean.angle), " {degrees} from the normal at ",
                                           Place(path.contacts[lean.point]),
                                           ", and the shank would touch the part: choose another axis ({setFixedAxis}), or leave it out")};
  path.axes.assign(path.contacts.size(), axis.cast<float>());
  figures.largest_lean = degrees(lean.angle);
  return Status::success();
}

/** Number of moves, without lifts, on which the normal turns faster than \p rate. */
std::size_t
fastMoves(const SpiralPath& path, double rate)
{
  std::size_t moves = 0;
  forPasses(path, [&](const Polyline& contacts, const std::vector<Eigen::Vector3d>& normals) {
    moves += movesTurningFaster(contacts, normals, rate);
  });
  return moves;
}

} // namespace

Status
setToolAxes(const SpiralSettings& settings, SpiralPath& path, AxisReport& figures, Diagnostics& warnings,
            const std::vector<Eigen::Vector3f>& obstacles)
{
  if (const Status status = checkGiven(path.contacts.size(), "the path"); !status.ok())
    return status;
  if (settings.fixed_axis)
    return setFixedAxis(settings.fixed_axis->normalized(), path, figures);
  std::vector<Eigen::Vector3d> wanted;
  SmoothAxes field = axesOf(path, settings, wanted);
  if (!obstacles.empty())
    easeBeside(obstacles, path, settings, field, warnings);
  const AxisLean lean = largestLean(path.normals, field.axes);
  if (liesInSurface(lean, path.normals, wanted))
    return {StatusCode::Failed, Diagnostic("the tool axis would lean ", degrees(lean.angle), " {degrees} from the normal at ",
                                           Place(path.contacts[lean.point]), " to keep the largest axis rate of ", settings.max_axis_rate,
                                           " {degrees} per {mm}: raise the axis rate ({setMaxAxisRate})")};
  const auto count = static_cast<std::int64_t>(field.axes.size());
  path.axes.resize(field.axes.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i)
    path.axes[i] = field.axes[i].cast<float>();
  figures.largest_change = degrees(field.largest_change);
  figures.largest_rate = degrees(field.largest_rate);
  figures.largest_deviation = degrees(field.largest_deviation);
  figures.largest_lean = degrees(lean.angle);
  figures.deviating_points = field.deviating_points;
  if (const std::size_t moves = fastMoves(path, radians(settings.max_axis_rate)); moves > 0)
    warnings.push_back(Diagnostic("on ", moves, " of ", count - 1, " moves the surface normal turns faster than the largest axis rate of ",
                                  settings.max_axis_rate,
                                  " {degrees} per {mm}: the tool axis cannot follow it there and differs from the set "
                                  "tilt by up to ",
                                  figures.largest_deviation, " {degrees}; allow a higher rate ({setMaxAxisRate}), or smooth the {scan}"));
  return Status::success();
}

} // namespace pcl_spiral
