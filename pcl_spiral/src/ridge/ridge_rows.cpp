// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/ridge/ridge_rows.h>

#include "ridge_row.h"
#include "row_metric.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

Status
invalid(const Diagnostic& message)
{
  return {StatusCode::InvalidArgument, message};
}

constexpr double longest = 1e5; // mm

Status
checkSettings(const RidgeRowSettings& s)
{
  const int told = (s.step_over != 0.0) + (s.spot_size != 0.0) + (s.tool_radius != 0.0);
  if (told != 1)
    return invalid(Diagnostic(
        told == 0 ? "no setting defines" : "more than one setting defines",
        " how far rows are apart: set the step-over ({setStepOver}), or the spot ({setSpot}), or ball and scallop height ({setScallop})"));
  for (const auto& [name, length] :
       {std::pair("step-over", s.step_over), std::pair("spot", s.spot_size), std::pair("tool radius", s.tool_radius),
        std::pair("spacing of points", s.point_spacing), std::pair("chord error", s.chord_error), std::pair("run-in", s.run_in),
        std::pair("run-out", s.run_out)})
    if (!(length >= 0.0 && length <= longest))
      return invalid(Diagnostic("the ", name, " is ", length, " {mm}: set it from 0 to ", longest, " {mm}"));
  if (!(s.overlap >= 0.0 && s.overlap < 1.0))
    return invalid(Diagnostic("the overlap is ", s.overlap, ": set it from 0 to below 1 ({setSpot})"));
  if (s.tool_radius > 0.0 && !(s.scallop_height > 0.0 && s.scallop_height < s.tool_radius))
    return invalid(Diagnostic("the scallop height is ", s.scallop_height, " {mm}: set it above 0 and below the tool radius, ",
                              s.tool_radius, " {mm} ({setScallop})"));
  if (!(s.point_spacing > 0.0))
    return invalid(Diagnostic("the spacing of points is ", s.point_spacing, " {mm}: set it above 0 ({setPointSpacing})"));
  if (!(s.stand_off >= 0.0 && s.stand_off <= longest))
    return invalid(Diagnostic("the stand-off is ", s.stand_off, " {mm}: set it from 0 to ", longest,
                              " {mm} ({setStandOff}); for the other side of the ridge "
                              "flip the normals ({setFlipNormals})"));
  if (!(std::abs(s.lead) < 90.0) || !(std::abs(s.tilt) < 90.0))
    return invalid(Diagnostic("lead and tilt are ", s.lead, " and ", s.tilt, " {degrees}: set them below 90 ({setLead}, {setTilt})"));
  return Status::success();
}

/** Largest distance of neighbouring rows at places \p places. */
double
largestDistance(const RidgeSurface& surface, bool along_rail, const std::vector<double>& places)
{
  constexpr int stations = 64;
  const SmoothLine &row = along_rail ? surface.rail() : surface.generator(), &across = along_rail ? surface.generator() : surface.rail();
  double largest = 0.0;
  for (std::size_t k = across.closed() && places.size() > 1 ? 0 : 1; k < places.size(); ++k)
    for (int i = 0; i <= stations; ++i) {
      const double t = row.length() * i / stations, a = places[k > 0 ? k - 1 : places.size() - 1], b = places[k];
      const Vector3d p = along_rail ? surface.position(t, a) : surface.position(a, t),
                     q = along_rail ? surface.position(t, b) : surface.position(b, t);
      largest = std::max(largest, (p - q).norm());
    }
  return largest;
}

} // namespace

Status
planRidgeRows(const RidgeSurface& surface, const RidgeRowSettings& settings, DrivePasses& passes, RidgeRowReport& report)
{
  passes.clear();
  report = RidgeRowReport();
  if (const Status status = checkSettings(settings); !status.ok())
    return status;
  std::vector<double> places;
  if (const Status status = rowPlaces(surface, settings, places); !status.ok())
    return status;
  const bool along_rail = settings.direction == RidgeDirection::AlongRail;
  report.largest_step = largestDistance(surface, along_rail, places);
  constexpr double most_points = 2e7;
  const double row = (along_rail ? surface.rail() : surface.generator()).length() + settings.run_in + settings.run_out;
  if (static_cast<double>(places.size()) * row / settings.point_spacing > most_points)
    return invalid(Diagnostic("the rows would have more than ", most_points,
                              " points: raise the spacing of points ({setPointSpacing}) or the step-over"));
  std::vector<RidgeRow> rows(places.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(places.size()); ++k)
    rows[static_cast<std::size_t>(k)] = ridgeRow(surface, settings, places[static_cast<std::size_t>(k)], settings.zigzag && k % 2 == 1);
  for (RidgeRow& made : rows) {
    passes.push_back(std::move(made.pass));
    if (made.backwards && report.warnings.empty())
      report.warnings.push_back(Diagnostic("at ", Place(*made.backwards),
                                           " the ridge is hollow with a smaller radius than the stand-off of ", settings.stand_off,
                                           " {mm}: the tool runs backwards there, and comes near the other side; set a smaller "
                                           "stand-off ({setStandOff})"));
  }
  report.rows = passes.size();
  for (const DrivePass& pass : passes) {
    report.points += pass.points.size();
    for (std::size_t i = 1; i < pass.points.size(); ++i)
      report.length += (pass.points[i].position - pass.points[i - 1].position).norm();
    if (pass.closed)
      report.length += (pass.points.front().position - pass.points.back().position).norm();
  }
  return Status::success();
}

} // namespace pcl_spiral
