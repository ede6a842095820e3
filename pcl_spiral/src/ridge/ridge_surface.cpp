// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include "generator_place.h"

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr int stations_across = 128; // of the generator

/** Number of stations along the rail, enough to follow its bends. */
int
stationsAlong(const SmoothLine& rail)
{
  constexpr double a_mm = 2.0;
  constexpr int least = 400, most = 20000;
  return static_cast<int>(std::clamp(a_mm * rail.length(), static_cast<double>(least), static_cast<double>(most)));
}

Vector3d
circleCentre(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const Vector3d u = b - a, v = c - a, w = u.cross(v);
  return a + (v.squaredNorm() * w.cross(u) + u.squaredNorm() * v.cross(w)) / (2.0 * w.squaredNorm());
}

} // namespace

std::vector<Setting>
settingTable(RidgeSettings& s)
{
  return {
      Setting("reference", "setReferenceNormal", "reference normal",
              "reference normal: the generator's chord keeps its angle to the plane with this normal, and this side is up; for an upright "
              "rail give a direction across it",
              "1,0,0", s.reference),
      Setting("measuring_error", "setMeasuringError", "measuring error", "standard deviation of a coordinate of the measured points",
              "0.02", s.measuring_error)
          .in("mm", NumberRange::from(0.0))
          .zeroFor("the one found from the points"),
      Setting("flip_normals", "setFlipNormals", "turned normals", "the tool is on the other side of the ridge", "", s.flip),
  };
}

/** The rail was checked at stations; if it is a little steeper between them, the chord is as steep as possible. */
RidgeFrame
RidgeSurface::frame(double u) const
{
  const Vector3d tangent = rail_.tangent(u);
  const double most = (1.0 - 1e-9) * tangent.cross(chord_.reference).norm();
  RidgeChord chord = chord_;
  chord.sin_angle = std::clamp(chord_.sin_angle, -most, most);
  return ridgeFrame(tangent, chord).value_or(RidgeFrame());
}

Vector3d
RidgeSurface::position(double u, double v) const
{
  return rail_.position(u) + frame(u).turned(generator_.position(v));
}

/** Derivative by the length of the rail: m1 + omega x (a, b, c), in the frame. */
Vector3d
RidgeSurface::alongRail(double u, double v) const
{
  const RidgeFrame at = frame(u);
  const Vector3d turn = ridgeTurn(at, rail_.curvature(u), chord_.reference);
  return at.turned(Vector3d::UnitX() + turn.cross(generator_.position(v)));
}

Vector3d
RidgeSurface::alongGenerator(double u, double v) const
{
  return frame(u).turned(generator_.tangent(v));
}

Vector3d
RidgeSurface::normal(double u, double v, RidgeNormals normals) const
{
  if (normals == RidgeNormals::True)
    return alongRail(u, v).cross(alongGenerator(u, v)).normalized();
  const Vector3d along = generator_.tangent(v);
  Vector3d local = Vector3d::UnitX().cross(along);
  if (normals == RidgeNormals::Arc && arc_centre_.allFinite()) {
    const Vector3d out = (generator_.position(v) - arc_centre_).cwiseProduct(Vector3d(0.0, 1.0, 1.0));
    local = out.dot(local) < 0.0 ? Vector3d(-out) : out;
  }
  return frame(u).turned(local).normalized();
}

Status
RidgeSurface::checkRail()
{
  constexpr double upright = 89.0;   // degrees: if it is steeper, the side of the chord is random
  constexpr double most_turn = 30.0; // degrees, of the chord from station to station
  const double limit = std::acos(std::min(1.0, std::abs(chord_.sin_angle)));
  const int stations = stationsAlong(rail_);
  Vector3d sensitive = Vector3d::Zero();
  std::optional<RidgeFrame> before;
  for (int k = 0; k <= stations; ++k) {
    const double u = rail_.length() * k / stations;
    const Vector3d tangent = rail_.tangent(u);
    const double slope = std::atan2(std::abs(tangent.dot(chord_.reference)), tangent.cross(chord_.reference).norm());
    const std::optional<RidgeFrame> at = ridgeFrame(tangent, chord_);
    if (!at)
      return {StatusCode::InvalidInput,
              Diagnostic("the rail has a slope of ", slope / degree, " {degrees} at ", Place(rail_.position(u)),
                         "; a generator with its chord at ", std::abs(report_.chord_angle), " {degrees} allows at most ", limit / degree,
                         ": set a reference normal across the rail ({setReferenceNormal}), or make the ridge in pieces")};
    if (slope / degree > upright || (before && std::acos(std::clamp(before->chord.dot(at->chord), -1.0, 1.0)) / degree > most_turn))
      return {
          StatusCode::InvalidInput,
          Diagnostic("the rail is upright, along the reference normal, at ", Place(rail_.position(u)),
                     ": the generator would turn over to "
                     "the other side there; set a reference normal across the rail ({setReferenceNormal}), or make the ridge in pieces")};
    before = at;
    if (slope / degree > report_.largest_slope) {
      report_.largest_slope = slope / degree;
      report_.steepest_place = rail_.position(u);
    }
    if (at->slopeFactor() > report_.slope_factor) {
      report_.slope_factor = at->slopeFactor();
      sensitive = rail_.position(u);
    }
  }
  warnOfSlope(sensitive);
  return Status::success();
}

void
RidgeSurface::warnOfSlope(const Vector3d& sensitive)
{
  constexpr double much = 5.0; // factor by which an error across the slope turns the chord; the same limit holds for tan(slope)
  if (report_.slope_factor > much)
    report_.warnings.push_back(Diagnostic("at ", Place(sensitive), " an error of the rail's slope turns the generator by ",
                                          report_.slope_factor,
                                          " times that error: measure the rail closely there, or set a reference normal across the rail "
                                          "({setReferenceNormal})"));
  else if (std::tan(report_.largest_slope * degree) > much)
    report_.warnings.push_back(Diagnostic("the rail is nearly upright at ", Place(report_.steepest_place), ", with a slope of ",
                                          report_.largest_slope, " {degrees}: an error of its direction turns the generator by ",
                                          std::tan(report_.largest_slope * degree),
                                          " times that error; set a reference normal across the rail "
                                          "({setReferenceNormal})"));
}

/** The surface folds where 1 + omega2 c - omega3 b <= 0: the share of its length along the rail. */
Status
RidgeSurface::checkFolds()
{
  const int stations = stationsAlong(rail_);
  double worst_u = 0.0, worst_v = 0.0;
  std::vector<Vector3d> across;
  for (int j = 0; j <= stations_across; ++j)
    across.push_back(generator_.position(generator_.length() * j / stations_across));
  for (int k = 0; k <= stations; ++k) {
    const double u = rail_.length() * k / stations;
    const Vector3d turn = ridgeTurn(frame(u), rail_.curvature(u), chord_.reference);
    for (int j = 0; j <= stations_across; ++j)
      if (const double stretch = 1.0 + turn.y() * across[j].z() - turn.z() * across[j].y(); stretch < report_.least_stretch) {
        report_.least_stretch = stretch;
        worst_u = u;
        worst_v = generator_.length() * j / stations_across;
      }
  }
  if (report_.least_stretch > 0.0)
    return Status::success();
  const double offset = generator_.position(worst_v).tail<2>().norm();
  return {StatusCode::InvalidInput, Diagnostic("the ridge folds at ", Place(position(worst_u, worst_v)), ": the generator reaches ", offset,
                                               " {mm} from the rail, but at most ", offset / (1.0 - report_.least_stretch),
                                               " {mm} are possible there, where the rail bends: measure a shorter generator")};
}

Status
RidgeSurface::place(const MeasuredLine& measured, bool may_turn, bool& turned)
{
  GeneratorPlace found;
  if (const Status status = placeGenerator(measured, rail_, settings_, may_turn, found); !status.ok())
    return status;
  turned = found.turns_rail;
  if (turned)
    return Status::success();
  report_.meeting = found.meeting;
  report_.meeting_place = rail_.position(found.meeting);
  report_.meeting_distance = found.distance;
  report_.tilt = found.tilt;
  report_.chord = found.chord_length;
  report_.chord_angle = std::asin(std::clamp(found.chord.sin_angle, -1.0, 1.0)) / degree;
  report_.warnings.insert(report_.warnings.end(), found.warnings.begin(), found.warnings.end());
  chord_ = found.chord;
  const LineFit fit = fitLine(found.local, settings_.measuring_error);
  generator_ = fit.line;
  report_.generator_error = fit.error;
  report_.generator_direction = directionError(found.local);
  report_.generator_length = generator_.length();
  const double v = generator_.length();
  arc_centre_ = circleCentre(generator_.position(0.0), generator_.position(0.5 * v), generator_.position(v));
  return Status::success();
}

/** Warn if rail and generator do not nearly meet, or if a rail is nearly a ring. */
void
RidgeSurface::warnOfMeeting(const MeasuredLine& rail, const MeasuredLine& generator)
{
  constexpr double errors = 5.0, spacings = 6.0;
  const double sure = errors * (report_.rail_error + report_.generator_error) + rail.spacing + generator.spacing;
  if (report_.meeting_distance > sure)
    report_.warnings.push_back(Diagnostic("rail and generator are ", report_.meeting_distance, " {mm} apart where they are closest, at ",
                                          Place(report_.meeting_place),
                                          ": the ridge runs through the generator there; if one of them was measured "
                                          "in another place, measure it again"));
  if (const double open = (rail.points.front() - rail.points.back()).norm(); !rail.closed && open < spacings * rail.spacing)
    report_.warnings.push_back(Diagnostic("the ends of the rail at ", Place(rail.points.front()), " are only ", open, " {mm} apart, ",
                                          open / rail.spacing,
                                          " spacings: if it is a ring, measure the rest of it; it is used as an open line"));
}

void
RidgeSurface::warnOfDirections()
{
  constexpr double much = 2.0; // degrees
  if (report_.generator_direction > much || report_.rail_direction > much)
    report_.warnings.push_back(
        Diagnostic("the direction of the ", report_.generator_direction > much ? "generator" : "rail", " is known to only ",
                   std::max(report_.generator_direction, report_.rail_direction), " {degrees}, because its points have an error of ",
                   report_.generator_direction > much ? report_.generator_error : report_.rail_error,
                   " {mm}: normals and tool axes have the same error; measure it with more points or a better probe"));
}

Status
RidgeSurface::fit(const Polyline& rail, const Polyline& generator)
{
  MeasuredLine measured_rail, measured_generator;
  if (const Status status = orderLine(rail, "the rail", measured_rail); !status.ok())
    return status;
  if (const Status status = orderLine(generator, "the generator", measured_generator); !status.ok())
    return status;
  const LineFit fit = fitLine(measured_rail, settings_.measuring_error);
  if (!(fit.line.length() > 0.0))
    return {StatusCode::InvalidInput, "no curve fits the points of the rail: do they lie along a line?"};
  if (const Status status = checkCorners(measured_rail, fit.error); !status.ok())
    return status;
  report_.rail_points = measured_rail.points.size();
  report_.generator_points = measured_generator.points.size();
  report_.closed = measured_rail.closed;
  report_.rail_error = fit.error;
  report_.rail_direction = directionError(measured_rail);
  report_.rail_length = fit.line.length();
  rail_ = fit.line;
  bool turned = false;
  Status status = place(measured_generator, true, turned);
  if (status.ok() && turned) {
    rail_ = rail_.reversed();
    status = place(measured_generator, false, turned);
  }
  if (status.ok())
    warnOfMeeting(measured_rail, measured_generator);
  return status;
}

Status
RidgeSurface::make(const Polyline& rail, const Polyline& generator, const RidgeSettings& settings, ConstPtr& result)
{
  result.reset();
  if (!settings.reference.allFinite() || !(settings.reference.norm() > 0.0))
    return {StatusCode::InvalidArgument, "the reference normal has no direction: set a vector such as (0, 0, 1) ({setReferenceNormal})"};
  if (const Diagnostic fault = rangeFault(settings); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  const auto made = std::make_shared<RidgeSurface>();
  made->settings_ = settings;
  made->settings_.reference.normalize();
  if (const Status status = made->fit(rail, generator); !status.ok())
    return status;
  if (RidgeReport& report = made->report_; report.closed) {
    made->rail_ = made->rail_.startingAt(report.meeting);
    report.meeting = 0.0;
  }
  if (const Status status = made->checkRail(); !status.ok())
    return status;
  if (const Status status = made->checkFolds(); !status.ok())
    return status;
  made->warnOfDirections();
  result = made;
  return Status::success();
}

} // namespace pcl_spiral
