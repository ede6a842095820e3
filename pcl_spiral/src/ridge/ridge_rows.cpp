// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/ridge/ridge_rows.h>

#include "choice_words.h"
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

constexpr double longest_ridge_setting = 1e5; // mm

Status
invalid(const Diagnostic& message)
{
  return {StatusCode::InvalidArgument, message};
}

Status
checkSettings(const RidgeRowSettings& s)
{
  const bool by_scallop = s.tool_radius != 0.0 || s.scallop_height != 0.0;
  const int told = (s.step_over != 0.0) + (s.spot_size != 0.0) + by_scallop;
  if (told != 1)
    return invalid(Diagnostic(
        told == 0 ? "no setting defines" : "more than one setting defines",
        " how far rows are apart: set the step-over ({setStepOver}), or the spot ({setSpot}), or ball and scallop height ({setToolRadius}, "
        "{setScallopHeight})"));
  if (const Diagnostic fault = rangeFault(s); !fault.empty())
    return invalid(fault);
  if (!(s.tool_radius >= 0.0 && s.tool_radius <= longest_ridge_setting))
    return invalid(
        Diagnostic("the tool radius is ", s.tool_radius, " {mm}: set it from 0 to ", longest_ridge_setting, " {mm} ({setToolRadius})"));
  if (by_scallop && !(s.scallop_height > 0.0 && s.scallop_height < s.tool_radius))
    return invalid(Diagnostic("the scallop height is ", s.scallop_height, " {mm}: set it above 0 and below the tool radius, ",
                              s.tool_radius, " {mm} ({setScallopHeight})"));
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

std::vector<Setting>
settingTable(RidgeRowSettings& s)
{
  const NumberRange length = NumberRange::from(0.0).upTo(longest_ridge_setting), angle = NumberRange::above(-90.0).below(90.0);
  return {
      Setting("direction", "setDirection", "direction of rows", "rows along the rail or across it", "across", s.direction),
      Setting("zigzag", "setZigzag", "zigzag", "every second row runs backwards", "", s.zigzag).writtenBy("one-way"),
      Setting("spot", "setSpot", "spot", "diameter of a beam's spot", "4", s.spot_size).in("mm", length).writtenBy("spot"),
      Setting("overlap", "setSpot", "overlap", "share of the spot that the next row covers again, below 1", "0.25", s.overlap)
          .in("", NumberRange::from(0.0).below(1.0)),
      Setting("step_over", "setStepOver", "step-over", "largest distance between neighbouring rows", "1", s.step_over)
          .in("mm", length)
          .writtenBy("step-over"),
      Setting("scallop", "setScallopHeight", "scallop height", "largest ridge height that a ball may leave between rows", "0.02",
              s.scallop_height)
          .in("mm", length)
          .writtenBy("scallop"),
      Setting("point_spacing", "setPointSpacing", "spacing of points", "largest distance between consecutive points", "0.5",
              s.point_spacing)
          .in("mm", NumberRange::above(0.0).upTo(longest_ridge_setting)),
      Setting("chord_error", "setChordError", "chord error", "largest distance of straight moves from the ridge", "0.005", s.chord_error)
          .in("mm", length)
          .zeroFor("no limit")
          .onlyInCode(),
      Setting("steps", "setSteps", "steps", "points at equal distances on each row, or, as published, at equal stations of the rail",
              "stations", s.steps),
      Setting(
          "normals", "setNormals", "normals",
          "true normals; as published, in the rail's normal plane (wrong where the ridge twists); or from an arc through start, middle and "
          "end of the generator",
          "in-plane", s.normals),
      Setting("stand_off", "setStandOff", "stand-off", "distance of a beam's tip from the surface, along the normal", "10", s.stand_off)
          .in("mm", length)
          .withRemedy("for the other side of the ridge flip the normals ({setFlipNormals})"),
      Setting("lead", "setLeadAngle", "lead angle", "lead of the tool axis, forward along the row", "5", s.lead).in("degrees", angle),
      Setting("tilt", "setTiltAngle", "tilt angle", "tilt of the tool axis, to the right of travel", "5", s.tilt).in("degrees", angle),
      Setting("run_in", "setRunIn", "run-in",
              "each row begins this far before the ridge, on a straight line; the code for the begin of a pass comes before it", "3",
              s.run_in)
          .in("mm", length),
      Setting("run_out", "setRunOut", "run-out", "each row ends this far behind the ridge; the code for the end of a pass comes after it",
              "3", s.run_out)
          .in("mm", length),
  };
}

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
                              " points: raise the spacing of points ({setPointSpacing}), or the step-over ({setStepOver})"));
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
