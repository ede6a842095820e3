// SPDX-License-Identifier: BSD-3-Clause
#include "generator_place.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>

#include "core/angle_between.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double largest_corner = 30.0;               // degrees
constexpr double warned_tilt = 2.0, most_tilt = 15.0; // degrees
constexpr double least_chord = 0.05;                  // of the generator's length

/** Twice the area inside a ring, along its normal. */
Vector3d
areaOf(const SmoothLine& ring)
{
  constexpr int stations = 400;
  const Vector3d centre = ring.position(0.0);
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < stations; ++k)
    sum += (ring.position(ring.length() * k / stations) - centre).cross(ring.position(ring.length() * (k + 1) / stations) - centre);
  return sum;
}

/** The place where both lines are closest: arc length of the rail, place of the generator. */
double
meetingOf(const SmoothLine& rail, const SmoothLine& generator, Vector3d& place)
{
  constexpr int stations = 100;
  const auto apart = [&](double v) {
    const Vector3d p = generator.position(v);
    return (rail.position(rail.nearest(p)) - p).norm();
  };
  const double step = generator.length() / stations;
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= stations; ++k)
    if (const double d = apart(k * step); d < least) {
      least = d;
      best = k;
    }
  double low = std::max(0, best - 1) * step, high = std::min(stations, best + 1) * step;
  for (int i = 0; i < 40; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    (apart(a) < apart(b) ? high : low) = apart(a) < apart(b) ? b : a;
  }
  place = generator.position(0.5 * (low + high));
  return rail.nearest(place);
}

/** Angle between the generator's plane and the plane across \p tangent; if it is nearly straight, the angle of its chord. */
double
tiltOf(const Polyline& points, const Vector3d& tangent)
{
  constexpr double straight = 0.05; // height over length
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points)
    mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points)
    spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vector3d chord = (points.back() - points.front()).normalized();
  if (solver.eigenvalues()[1] < straight * straight * solver.eigenvalues()[2])
    return std::asin(std::min(1.0, std::abs(chord.dot(tangent)))) / degree;
  const Vector3d normal = solver.eigenvectors().col(0);
  return std::atan2(normal.cross(tangent).norm(), std::abs(normal.dot(tangent))) / degree;
}

/** Find where \p generator meets \p rail; refused if they do not meet, or if the generator has no chord. */
Status
findMeeting(const SmoothLine& generator, const SmoothLine& rail, Vector3d& meeting, GeneratorPlace& place)
{
  if (!(generator.length() > 0.0))
    return {StatusCode::InvalidInput, "no curve fits the points of the generator: do they lie along a line?"};
  place.chord_length = (generator.position(generator.length()) - generator.position(0.0)).norm();
  if (!(place.chord_length > least_chord * generator.length()))
    return {StatusCode::InvalidInput, Diagnostic("start and end of the generator at ", Place(generator.position(0.0)), " are ",
                                                 place.chord_length, " {mm} apart, less than a twentieth of its length, ",
                                                 generator.length(), " {mm}: its chord defines no direction; measure an open profile")};
  place.meeting = meetingOf(rail, generator, meeting);
  const Vector3d foot = rail.position(place.meeting);
  place.distance = (meeting - foot).norm();
  const double beyond = std::abs((meeting - foot).dot(rail.tangent(place.meeting)));
  if (!rail.closed() && beyond > 0.5 * place.distance && beyond > least_chord * place.chord_length)
    return {StatusCode::InvalidInput,
            Diagnostic("the generator at ", Place(meeting), " lies ", beyond, " {mm} beyond the end of the rail at ", Place(foot),
                       ": measure it across the rail, or measure a longer rail")};
  if (place.distance > generator.length())
    return {StatusCode::InvalidInput, Diagnostic("the generator at ", Place(meeting), " is ", place.distance, " {mm} from the rail, at ",
                                                 Place(foot), ", more than its own length, ", generator.length(),
                                                 " {mm}: do both lines belong to the same ridge, in the same unit?")};
  return Status::success();
}

/** Warn of the tilt of \p points against the plane across \p tangent, or refuse it. */
Status
checkTilt(const Polyline& points, const Vector3d& tangent, const Vector3d& meeting, GeneratorPlace& place)
{
  place.tilt = tiltOf(points, tangent);
  const Diagnostic tilted =
      Diagnostic("the generator at ", Place(meeting), " is tilted by ", place.tilt, " {degrees} against the normal plane of the rail");
  if (place.tilt > most_tilt)
    return {StatusCode::InvalidInput, Diagnostic(tilted, "; at most ", most_tilt, " are allowed: measure it square to the rail")};
  if (place.tilt > warned_tilt)
    place.warnings.push_back(Diagnostic(tilted, ": its shape is used as measured"));
  return Status::success();
}

} // namespace

Status
checkCorners(const MeasuredLine& rail, double error)
{
  constexpr double steady = 40.0; // times the error of a point: shorter pieces do not define a direction
  const std::size_t n = rail.points.size();
  const auto reach = static_cast<std::size_t>(std::max(2.0, std::ceil(steady * error / rail.spacing)));
  const auto turnAt = [&](std::size_t i) {
    if (!rail.closed && (i < reach || i + reach >= n))
      return 0.0;
    const Vector3d a = rail.points[i] - rail.points[(i + n - reach) % n], b = rail.points[(i + reach) % n] - rail.points[i];
    return angleBetween(a, b) / degree;
  };
  for (std::size_t i = 0; i < n && 4 * reach < n; ++i) {
    const double turn = turnAt(i), beside = std::max(turnAt((i + 2 * reach) % n), turnAt((i + n - 2 * reach) % n));
    if (turn > largest_corner && beside < 0.5 * turn)
      return {StatusCode::InvalidInput,
              Diagnostic("the rail has a corner of ", turn, " {degrees} at ", Place(rail.points[i]), "; it must be smooth, with less than ",
                         largest_corner, " {degrees} at one place: make one ridge of each side of the corner")};
  }
  return Status::success();
}

Status
placeGenerator(const MeasuredLine& measured, const SmoothLine& rail, const RidgeSettings& settings, bool may_turn, GeneratorPlace& place)
{
  place = GeneratorPlace();
  const SmoothLine generator = fitLine(measured, settings.measuring_error).line;
  Vector3d meeting;
  if (const Status status = findMeeting(generator, rail, meeting, place); !status.ok())
    return status;
  place.turns_rail = may_turn && (rail.closed() ? areaOf(rail).dot(settings.reference) < 0.0 : place.meeting > 0.5005 * rail.length());
  if (place.turns_rail)
    return Status::success();
  const Vector3d foot = rail.position(place.meeting), tangent = rail.tangent(place.meeting);
  if (const Status status = checkTilt(measured.points, tangent, meeting, place); !status.ok())
    return status;
  Vector3d chord = generator.position(generator.length()) - generator.position(0.0);
  const bool turned = (chord.dot(settings.reference.cross(tangent)) < 0.0) != settings.flip;
  if (turned)
    chord = -chord;
  place.chord = ridgeChord(tangent, (chord - chord.dot(tangent) * tangent).normalized(), settings.reference);
  const std::optional<RidgeFrame> frame = ridgeFrame(tangent, place.chord);
  if (!frame)
    return {StatusCode::InvalidInput,
            Diagnostic("the chord of the generator at ", Place(meeting),
                       " is parallel to the reference normal, so it is not clear on which "
                       "side of the rail it is: set another reference normal, across both lines ({setReferenceNormal})")};
  constexpr double sure = 0.1; // of the chord's length, away from the upright plane through the rail
  if (std::abs(frame->up.dot(settings.reference)) < sure)
    place.warnings.push_back(Diagnostic("the generator at ", Place(meeting),
                                        " is nearly upright, so errors of its points may decide which "
                                        "side is up: check the normals, and flip them ({setFlipNormals}) or set a reference normal across "
                                        "the generator ({setReferenceNormal})"));
  place.local.spacing = measured.spacing;
  for (const Vector3d& p : measured.points)
    place.local.points.push_back(frame->localOf(p - foot));
  if (turned)
    std::reverse(place.local.points.begin(), place.local.points.end());
  return Status::success();
}

} // namespace pcl_spiral
