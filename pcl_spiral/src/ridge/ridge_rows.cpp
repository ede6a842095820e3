#include <pcl_spiral/ridge/ridge_rows.h>

#include "row_metric.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/core/tool_axis.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

Status
invalid(const std::string& message)
{
  return {StatusCode::InvalidArgument, message};
}

constexpr double longest = 1e5; // mm

Status
checkSettings(const RidgeRowSettings& s)
{
  const int told = (s.step_over != 0.0) + (s.spot_size != 0.0) + (s.tool_radius != 0.0);
  if (told != 1)
    return invalid(textOf(told == 0 ? "nothing tells" : "more than one setting tells",
                          " how far rows are apart: set the step-over (setStepOver), or the spot (setSpot), or ball and scallop height (setScallop)"));
  for (const double length : {s.step_over, s.spot_size, s.tool_radius, s.point_spacing, s.run_in, s.run_out})
    if (!(length >= 0.0 && length <= longest))
      return invalid(textOf("a length is ", length, " mm: set step-over, spot, tool radius, spacing, run-in and run-out from 0 to ", longest, " mm"));
  if (!(s.overlap >= 0.0 && s.overlap < 1.0))
    return invalid(textOf("the overlap is ", s.overlap, ": set it from 0 to below 1 (setSpot)"));
  if (s.tool_radius > 0.0 && !(s.scallop_height > 0.0 && s.scallop_height < s.tool_radius))
    return invalid(textOf("the scallop height is ", s.scallop_height, " mm: set it above 0 and below the tool radius, ", s.tool_radius,
                          " mm (setScallop)"));
  if (!(s.point_spacing > 0.0))
    return invalid(textOf("the spacing of points is ", s.point_spacing, " mm: set it above 0 (setPointSpacing)"));
  if (!(std::abs(s.stand_off) <= longest))
    return invalid(textOf("the stand-off is ", s.stand_off, " mm: set it up to ", longest, " mm (setStandOff)"));
  if (!(std::abs(s.lead) < 90.0) || !(std::abs(s.tilt) < 90.0))
    return invalid(textOf("lead and tilt are ", s.lead, " and ", s.tilt, " degrees: set them below 90 (setLead, setTilt)"));
  return Status::success();
}

/** One row: places of the surface as its parameter runs. */
class Row {
public:
  Row(const RidgeSurface& surface, const RidgeRowSettings& settings, double place)
  : surface_(surface), settings_(settings), along_rail_(settings.direction == RidgeDirection::AlongRail), place_(place)
  {
  }

  bool closed() const { return line().closed(); }

  DrivePass
  pass(bool turned) const
  {
    std::vector<double> at = parameters();
    if (turned)
      std::reverse(at.begin() + (closed() ? 1 : 0), at.end());
    DrivePass pass;
    pass.closed = closed();
    Polyline places;
    std::vector<Vector3d> normals;
    for (const double t : at) {
      const double u = along_rail_ ? t : place_, v = along_rail_ ? place_ : t;
      normals.push_back(surface_.normal(u, v, settings_.normals));
      places.push_back(surface_.position(u, v) + settings_.stand_off * normals.back());
    }
    if (!pass.closed)
      runOver(places, normals);
    const std::vector<Vector3d> axes = axesOf(places, normals);
    for (std::size_t i = 0; i < places.size(); ++i)
      pass.points.push_back({places[i], axes[i], normals[i]});
    return pass;
  }

private:
  const SmoothLine& line() const { return along_rail_ ? surface_.rail() : surface_.generator(); }

  /** Of the points, a closed row's last left out. */
  std::vector<double>
  parameters() const
  {
    const double length = line().length();
    std::vector<double> fine{0.0}, ways{0.0}; // parameter, length of the row up to it
    if (settings_.steps == RidgeSteps::EqualOnRow) {
      constexpr double parts = 8.0; // of a step: chords stand for the row
      const int pieces = static_cast<int>(std::ceil(parts * length / settings_.point_spacing)) + 8;
      Vector3d before = at(0.0);
      for (int k = 1; k <= pieces; ++k) {
        fine.push_back(length * k / pieces);
        const Vector3d next = at(fine.back());
        ways.push_back(ways.back() + (next - before).norm());
        before = next;
      }
    }
    else {
      fine.push_back(length);
      ways.push_back(length);
    }
    const int count = std::max(closed() ? 3 : 1, static_cast<int>(std::ceil(ways.back() / settings_.point_spacing - 1e-9)));
    std::vector<double> result;
    std::size_t piece = 1;
    for (int k = 0; k < count + (closed() ? 0 : 1); ++k) {
      const double way = ways.back() * k / count;
      while (piece + 1 < ways.size() && ways[piece] < way)
        ++piece;
      result.push_back(fine[piece - 1] + (fine[piece] - fine[piece - 1]) * (way - ways[piece - 1]) / (ways[piece] - ways[piece - 1]));
    }
    return result;
  }

  Vector3d
  at(double t) const
  {
    return along_rail_ ? surface_.position(t, place_) : surface_.position(place_, t);
  }

  /** Of a ring too, whose first and last point are neighbours. */
  std::vector<Vector3d>
  axesOf(Polyline places, std::vector<Vector3d> normals) const
  {
    const double degree = M_PI / 180.0;
    if (closed()) {
      places.insert(places.begin(), places.back());
      normals.insert(normals.begin(), normals.back());
      places.push_back(places[1]);
      normals.push_back(normals[1]);
    }
    std::vector<Vector3d> axes = tiltedAxes(places, normals, settings_.tilt * degree, settings_.lead * degree);
    if (closed()) {
      axes.erase(axes.begin());
      axes.pop_back();
    }
    return axes;
  }

  /** Straight on at both ends. */
  void
  runOver(Polyline& places, std::vector<Vector3d>& normals) const
  {
    const auto add = [&](double length) { // behind the last
      const Vector3d end = places.back(), way = (end - places[places.size() - 2]).normalized(), normal = normals.back();
      const int steps = static_cast<int>(std::ceil(length / settings_.point_spacing - 1e-9));
      for (int k = 1; k <= steps; ++k) {
        places.push_back(end + way * (length * k / steps));
        normals.push_back(normal);
      }
    };
    add(settings_.run_out);
    std::reverse(places.begin(), places.end());
    std::reverse(normals.begin(), normals.end());
    add(settings_.run_in);
    std::reverse(places.begin(), places.end());
    std::reverse(normals.begin(), normals.end());
  }

  const RidgeSurface& surface_;
  const RidgeRowSettings& settings_;
  bool along_rail_;
  double place_;
};

} // namespace

Status
planRidgeRows(const RidgeSurface& surface, const RidgeRowSettings& settings, DrivePasses& passes, RidgeRowReport& report)
{
  passes.clear();
  report = RidgeRowReport();
  if (const Status status = checkSettings(settings); !status.ok())
    return status;
  std::vector<double> places;
  if (const Status status = rowPlaces(surface, settings, places, report.largest_step); !status.ok())
    return status;
  constexpr double most_points = 2e7;
  const double row = std::max(surface.rail().length(), surface.generator().length()) + settings.run_in + settings.run_out;
  if (static_cast<double>(places.size()) * row / settings.point_spacing > most_points)
    return invalid(textOf("the rows would have more than ", most_points, " points: raise the spacing of points (setPointSpacing) or the step-over"));
  passes.resize(places.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(places.size()); ++k) {
    const Row row(surface, settings, places[static_cast<std::size_t>(k)]);
    passes[static_cast<std::size_t>(k)] = row.pass(settings.zigzag && k % 2 == 1);
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
