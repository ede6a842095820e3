// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>

#include "core/revolution_axis.h"
#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_sampled = 20000; // points for the fit of the axis
constexpr double least_radial = 0.7;        // rms share of the normals away from the axis
constexpr double most_turning = 0.5;        // and around it
constexpr double most_uncertainty = 0.4;    // radians, of a single point
constexpr double least_covered = 90.0;      // degrees about the axis
constexpr double facing_along = 0.25;       // share away from the axis below which a place faces along it
constexpr double most_facing_along = 0.2;   // of the area

double
areaAt(const SurfaceGraph& graph, std::size_t i)
{
  return graph.spacing(i) * graph.spacing(i);
}

Status
noColumn(const Diagnostic& why)
{
  return {StatusCode::InvalidInput, Diagnostic("the part is not shaped like a column: ", why,
                                               "; remove what does not belong to the column, give its axis "
                                               "({setCylinder}), or choose section planes")};
}

/** Share of the area that faces along the axis and not away from it. */
double
shareFacingAlong(const SurfaceGraph& graph, const DriveCylinder& cylinder)
{
  double along = 0.0, all = 0.0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const double area = areaAt(graph, i), n = graph.normal(i).dot(cylinder.direction);
    along += 1.0 - n * n < facing_along * facing_along ? area : 0.0;
    all += area;
  }
  return along / all;
}

Status
fitCylinder(const SurfaceGraph& graph, DriveColumn& column)
{
  std::vector<Eigen::Vector3d> points, normals;
  std::vector<double> weights;
  const std::size_t stride = std::max<std::size_t>(1, (graph.size() + most_sampled - 1) / most_sampled);
  for (std::size_t i = 0; i < graph.size(); i += stride) {
    points.push_back(graph.position(i));
    normals.push_back(graph.normal(i).normalized());
    weights.push_back(areaAt(graph, i));
  }
  const auto axis = fitRevolutionAxis(points, normals, weights);
  if (!axis)
    return noColumn("its normals point to no common axis");
  if (axis->uncertainty > most_uncertainty)
    return noColumn("its normals do not define an axis, as on a sphere or a plate");
  if (axis->radial < least_radial)
    return noColumn(Diagnostic("for the best axis, ", Direction(axis->direction), ", the radial share of its normals is only ",
                               axis->radial, ", but at least ", least_radial, " is needed"));
  if (axis->turning > most_turning)
    return noColumn(Diagnostic("for the best axis, ", Direction(axis->direction), ", its normals differ from the radial direction by ",
                               std::asin(std::min(1.0, axis->turning)) * in_degrees, " {degrees} (rms), but at most ",
                               std::asin(most_turning) * in_degrees, " are allowed"));
  column.cylinder.origin = axis->origin;
  column.cylinder.direction = axis->direction;
  double square = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d across = axis->direction.cross(normals[i]);
    if (across.norm() < facing_along)
      continue;
    const double miss = across.normalized().dot(points[i] - axis->origin);
    square += weights[i] * miss * miss;
    whole += weights[i];
  }
  column.normal_miss = std::sqrt(square / whole);
  if (const double share = shareFacingAlong(graph, column.cylinder); share > most_facing_along)
    return noColumn(Diagnostic(100.0 * share, " % of its area faces along the best axis, ", Direction(axis->direction)));
  return Status::success();
}

/** Radii and extent of the points between the ends of a given cylinder. False if there are none. */
bool
measure(const SurfaceGraph& graph, DriveColumn& column)
{
  DriveCylinder& c = column.cylinder;
  const bool whole_scan = c.first == c.last;
  double low = 1e300, high = -1e300, radius = 0.0, whole = 0.0;
  column.least_radius = 1e300;
  column.largest_radius = 0.0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const Eigen::Vector3d x = graph.position(i) - c.origin;
    const double along = x.dot(c.direction), r = x.cross(c.direction).norm(), area = areaAt(graph, i);
    if (!whole_scan && (along < c.first || along > c.last))
      continue;
    low = std::min(low, along);
    high = std::max(high, along);
    column.least_radius = std::min(column.least_radius, r);
    column.largest_radius = std::max(column.largest_radius, r);
    radius += area * r;
    whole += area;
  }
  if (!(whole > 0.0))
    return false;
  column.radius = radius / whole;
  if (whole_scan) {
    c.first = low;
    c.last = high;
  }
  return true;
}

/** The widest angle without points counts as not covered if it is wider than the gaps of the scan. */
void
measureSector(const SurfaceGraph& graph, DriveColumn& column)
{
  constexpr double spacings = 8.0, least = 2.0 / in_degrees;
  const DriveCylinder& c = column.cylinder;
  const Eigen::Vector3d e1 = referenceAcross(c.direction), e2 = c.direction.cross(e1);
  std::vector<double> angles;
  angles.reserve(graph.size() + 1);
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const Eigen::Vector3d x = graph.position(i) - c.origin;
    if (const double along = x.dot(c.direction); along >= c.first && along <= c.last)
      angles.push_back(std::atan2(x.dot(e2), x.dot(e1)));
  }
  std::sort(angles.begin(), angles.end());
  angles.push_back(angles.front() + 2.0 * pi);
  double widest = 0.0;
  std::size_t after = 0;
  for (std::size_t i = 1; i < angles.size(); ++i)
    if (angles[i] - angles[i - 1] > widest) {
      widest = angles[i] - angles[i - 1];
      after = i;
    }
  column.covered_angle = 360.0;
  column.first_angle = 0.0;
  if (widest <= std::max(least, spacings * graph.spacing() / column.radius))
    return;
  column.covered_angle = 360.0 - widest * in_degrees;
  column.first_angle = std::fmod(angles[after] * in_degrees + 360.0, 360.0);
}

} // namespace

Eigen::Vector3d
referenceAcross(const Eigen::Vector3d& axis)
{
  const Eigen::Vector3d from = std::abs(axis.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY();
  return (from - axis * axis.dot(from)).normalized();
}

Eigen::Vector3d
placeAbout(const DriveCylinder& c, double radius, double angle, double along)
{
  const Eigen::Vector3d e1 = referenceAcross(c.direction), e2 = c.direction.cross(e1);
  return c.origin + along * c.direction + radius * (std::cos(angle) * e1 + std::sin(angle) * e2);
}

Status
checkCylinder(const DriveCylinder& c)
{
  if (!c.origin.allFinite() || !c.direction.allFinite() || !std::isfinite(c.first) || !std::isfinite(c.last))
    return {StatusCode::InvalidArgument, "the drive cylinder is not finite; set its origin, direction and ends"};
  if (!(c.direction.norm() > 1e-9))
    return {StatusCode::InvalidArgument, "the axis of the drive cylinder has no length; set its direction"};
  if (c.last < c.first)
    return {StatusCode::InvalidArgument,
            Diagnostic("the drive cylinder runs from ", c.first, " to ", c.last,
                       " {mm} along its axis; set the last end above the first, or both to 0 for the whole scan")};
  return Status::success();
}

Status
findColumn(const SurfaceGraph& graph, const std::optional<DriveCylinder>& given, DriveColumn& column)
{
  column = DriveColumn();
  column.fitted = !given;
  if (given) {
    column.cylinder = *given;
    column.cylinder.direction.normalize();
  }
  else if (const Status status = fitCylinder(graph, column); !status.ok())
    return status;
  if (!measure(graph, column) || !(column.radius > 0.0))
    return {StatusCode::InvalidInput, Diagnostic("no point of the part lies between ", column.cylinder.first, " and ", column.cylinder.last,
                                                 " {mm} along the axis of the drive cylinder from ", Place(column.cylinder.origin),
                                                 "; set its ends to enclose the surface")};
  measureSector(graph, column);
  if (column.fitted && column.covered_angle < least_covered)
    return noColumn(Diagnostic("it covers only ", column.covered_angle, " {degrees} about the best axis, ",
                               Direction(column.cylinder.direction), ", but at least ", least_covered, " are needed"));
  return Status::success();
}

} // namespace pcl_spiral
