// SPDX-License-Identifier: BSD-3-Clause
#include "cutter_actor.h"

#include "visualization/actors.h"
#include "visualization/path_layer.h"

#include <pcl_spiral/core/impl/angles.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int sectors = 120, ball_rings = 30;
constexpr double shank_length = 5.0, ///< ball radii
    opacity = 0.6;
constexpr Color cutter_color{0.95, 0.70, 0.25};

/** A half profile turned round the axis \p up through \p centre; its points are radius and height. */
vtkSmartPointer<vtkPolyData>
revolved(const std::vector<Eigen::Vector2d>& profile, const Eigen::Vector3d& centre, const Eigen::Vector3d& up)
{
  const Eigen::Vector3d across = up.unitOrthogonal(), side = up.cross(across);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  for (const Eigen::Vector2d& p : profile)
    for (int k = 0; k < sectors; ++k) {
      const double angle = 2.0 * pi * k / sectors;
      const Eigen::Vector3d place = centre + p.x() * (std::cos(angle) * across + std::sin(angle) * side) + p.y() * up;
      points->InsertNextPoint(place.data());
    }
  for (vtkIdType ring = 0; ring + 1 < static_cast<vtkIdType>(profile.size()); ++ring)
    for (vtkIdType k = 0; k < sectors; ++k) {
      const vtkIdType a = ring * sectors + k, b = ring * sectors + (k + 1) % sectors;
      const vtkIdType corners[4] = {a, b, b + sectors, a + sectors};
      faces->InsertNextCell(4, corners);
    }
  auto body = vtkSmartPointer<vtkPolyData>::New();
  body->SetPoints(points);
  body->SetPolys(faces);
  return body;
}

/** Height of the upper end of the flank. */
double
flankEnd(const CutterProfile& shape)
{
  return std::max(shape.topHeight(), shape.cornerHeight());
}

} // namespace

vtkSmartPointer<vtkActor>
cutterActor(const ToolpathPoint& point, double radius)
{
  std::vector<Eigen::Vector2d> profile;
  for (int k = 0; k <= ball_rings; ++k) {
    const double angle = 0.5 * pi * k / ball_rings; // from the tip
    profile.emplace_back(radius * std::sin(angle), -radius * std::cos(angle));
  }
  profile.emplace_back(radius, shank_length * radius);
  profile.emplace_back(0.0, shank_length * radius);
  const Eigen::Vector3d axis = point.getAxisVector3fMap().cast<double>(), normal = normalOf(point);
  const auto actor =
      surfaceActor(revolved(profile, placeOf(point) + radius * normal, axis.norm() > 0.5 ? axis.normalized() : normal), cutter_color);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

vtkSmartPointer<vtkActor>
toolActor(const CutterShape& cutter, const std::vector<ToolSegment>& holder)
{
  const CutterProfile shape(cutter);
  std::vector<Eigen::Vector2d> profile{{0.0, 0.0}};
  for (int k = 0; k <= ball_rings; ++k) { // the corner, from the flat to the flank
    const double angle = (0.5 * pi - shape.flankAngle()) * k / ball_rings, r = shape.cornerRadius();
    profile.emplace_back(shape.flatRadius() + r * std::sin(angle), r - r * std::cos(angle));
  }
  double height = flankEnd(shape);
  profile.emplace_back(shape.radius(), height);
  if (holder.empty())
    profile.emplace_back(shape.radius(), height += shank_radii * shape.radius());
  for (const ToolSegment& segment : holder) {
    profile.emplace_back(segment.lower_radius, height);
    profile.emplace_back(segment.upper_radius, height += segment.length);
  }
  profile.emplace_back(0.0, height);
  auto actor = surfaceActor(revolved(profile, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()), cutter_color);
  actor->GetProperty()->SetOpacity(opacity);
  return actor;
}

double
toolHeight(const CutterShape& cutter, const std::vector<ToolSegment>& holder)
{
  const CutterProfile shape(cutter);
  double height = flankEnd(shape) + (holder.empty() ? shank_radii * shape.radius() : 0.0);
  for (const ToolSegment& segment : holder)
    height += segment.length;
  return height;
}

} // namespace pcl_spiral
