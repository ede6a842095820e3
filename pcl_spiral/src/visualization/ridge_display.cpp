// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_display.h"

#include <pcl_spiral/ridge/ridge_surface.h>

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <Eigen/Geometry>

#include <limits>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr double flatness = 5e-5; ///< of the ridge's size: a twentieth of a pixel, so that values between corners are also right

double
sizeOf(const RidgeSurface& ridge)
{
  Eigen::AlignedBox3d box;
  for (const double u : stationsAlong(ridge.rail(), 100))
    box.extend(ridge.position(u, 0.0)).extend(ridge.position(u, ridge.generator().length()));
  return box.diagonal().norm();
}

/** Normals and values at the points. Returns the mean normal. */
Eigen::Vector3d
addPointData(const RidgeSurface& ridge, const RidgeMesh& mesh, const std::function<double(double, double)>& value, vtkPolyData* data)
{
  vtkNew<vtkFloatArray> normals, values;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    const std::size_t row = k / (mesh.across + 1), column = k % (mesh.across + 1);
    const double u = ridge.rail().length() * static_cast<double>(row) / static_cast<double>(mesh.along);
    const double v = ridge.generator().length() * static_cast<double>(column) / static_cast<double>(mesh.across);
    const Eigen::Vector3d normal = ridge.normal(u, v);
    sum += normal;
    normals->InsertNextTuple(normal.data());
    values->InsertNextValue(static_cast<float>(value(u, v)));
  }
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->SetScalars(values);
  return sum / static_cast<double>(mesh.vertices.size());
}

} // namespace

std::vector<double>
stationsAlong(const SmoothLine& line, int steps)
{
  const int count = steps + (line.closed() ? 0 : 1);
  std::vector<double> places;
  places.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    places.push_back(line.length() * k / steps);
  return places;
}

DisplaySurface
ridgeDisplay(const RidgeSurface::ConstPtr& ridge, const std::function<double(double, double)>& value)
{
  if (!ridge)
    throw std::invalid_argument("a picture of a ridge needs the ridge");
  constexpr double coarser = 4.0;
  constexpr int most_rounds = 5;
  RidgeMesh mesh;
  double chord_error = flatness * sizeOf(*ridge);
  Status status = ridgeMesh(*ridge, chord_error, mesh);
  for (int round = 0; status.code() == StatusCode::InvalidArgument && round < most_rounds; ++round)
    status = ridgeMesh(*ridge, chord_error *= coarser, mesh); // a tight bend at one place needs too many faces everywhere
  if (!status.ok())
    throw std::invalid_argument("the picture of the ridge cannot be drawn: " + status.message());
  DisplaySurface surface;
  surface.low.setConstant(std::numeric_limits<double>::max());
  surface.high = -surface.low;
  surface.of_mesh = true;
  extend(surface, mesh.vertices);
  vtkNew<vtkPoints> points;
  for (const Eigen::Vector3d& p : mesh.vertices)
    points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> triangles;
  for (const auto& face : mesh.faces) {
    const vtkIdType corners[3] = {face[0], face[1], face[2]};
    triangles->InsertNextCell(3, corners);
  }
  surface.mesh = vtkSmartPointer<vtkPolyData>::New();
  surface.mesh->SetPoints(points);
  surface.mesh->SetPolys(triangles);
  const Eigen::Vector3d mean = addPointData(*ridge, mesh, value, surface.mesh);
  constexpr double least_mean_normal = 0.25; // a shorter mean of unit normals gives no side
  surface.outward = mean.norm() > least_mean_normal ? mean.normalized() : Eigen::Vector3d::Zero().eval();
  return surface;
}

void
extend(DisplaySurface& surface, const Polyline& places)
{
  for (const Eigen::Vector3d& p : places)
    if (p.allFinite()) {
      surface.low = surface.low.cwiseMin(p);
      surface.high = surface.high.cwiseMax(p);
    }
}

void
addArrow(std::vector<Polyline>& lines, const Eigen::Vector3d& from, const Eigen::Vector3d& arrow, const Eigen::Vector3d& towards)
{
  constexpr double head = 0.25, half_width = 0.10; // of the arrow's length
  const Eigen::Vector3d tip = from + arrow, side = half_width * arrow.norm() * arrow.cross(towards).normalized();
  lines.push_back({from, tip});
  lines.push_back({tip - head * arrow + side, tip, tip - head * arrow - side});
}

Polyline
generatorAt(const RidgeSurface& ridge, double u)
{
  Polyline line;
  for (const double v : stationsAlong(ridge.generator(), 100))
    line.push_back(ridge.position(u, v));
  return line;
}

} // namespace pcl_spiral
