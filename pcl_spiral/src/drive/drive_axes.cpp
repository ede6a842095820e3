// SPDX-License-Identifier: BSD-3-Clause
// Tool axes of drive points.
#include "drive_kinds.h"

#include "search/neighbour_search.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
using Pointers = std::vector<DrivePoint*>;

Pointers
pointsIn(DrivePasses& passes)
{
  Pointers all;
  for (DrivePass& pass : passes)
    for (DrivePoint& point : pass.points)
      all.push_back(&point);
  return all;
}

Status
setRadial(const DriveColumn& column, const Pointers& points)
{
  constexpr double least = 1e-3; // mm from the axis
  for (DrivePoint* p : points) {
    const Vector3d x = p->position - column.cylinder.origin, d = column.cylinder.direction;
    p->axis = x - d * d.dot(x);
    if (!(p->axis.norm() > least))
      return {StatusCode::InvalidInput, Diagnostic("the drive point ", Place(p->position),
                                                   " lies on the axis of the drive cylinder, so no direction "
                                                   "leads away from that axis; move the cylinder's "
                                                   "axis, or choose another axis mode")};
    p->axis.normalize();
  }
  return Status::success();
}

/** Normals by PCA of the nearest points of the scan, as many as for a normal of the graph.
 */
void
setPlaneNormals(const SurfaceGraph& graph, const Pointers& points)
{
  constexpr std::int64_t run = 64;
  const auto count = static_cast<std::int64_t>(points.size());
#pragma omp parallel
  {
    NeighbourSearch search(graph.blocks(), graph.neighbours());
#pragma omp for schedule(dynamic)
    for (std::int64_t first = 0; first < count; first += run) {
      Box box;
      for (std::int64_t i = first; i < std::min(count, first + run); ++i)
        box.extend(points[i]->position.cast<float>().eval().data());
      search.setRun(box);
      for (std::int64_t i = first; i < std::min(count, first + run); ++i) {
        const Neighbourhood& near = search.find(points[i]->position);
        Vector3d mean = Vector3d::Zero();
        for (int j = 0; j < near.size; ++j)
          mean += graph.position(near.index[j]) / near.size;
        Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        for (int j = 0; j < near.size; ++j) {
          const Vector3d d = graph.position(near.index[j]) - mean;
          spread += d * d.transpose();
        }
        Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
        if (normal.dot(graph.normal(near.index[0])) < 0.0)
          normal = -normal;
        points[i]->axis = normal;
      }
    }
  }
}

/** Feet of the places on the surface. A place far from it first moves to the nearest point, then across the
 *  normals until the normal leads to the place. */
std::vector<SurfaceFoot>
feetOf(const MlsSurface& surface, const Pointers& points)
{
  constexpr int rounds = 8;
  const SurfaceGraph& graph = surface.graph();
  std::vector<Vector3d> places;
  for (const DrivePoint* p : points)
    places.push_back(p->position);
  std::vector<SurfaceFoot> feet;
  surface.project(places, feet);
  std::vector<std::size_t> far;
  for (std::size_t i = 0; i < feet.size(); ++i)
    if (!feet[i].valid || (feet[i].position - places[i]).norm() > graph.spacing())
      far.push_back(i);
  std::vector<Vector3d> queries(far.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(far.size()); ++k)
    queries[k] = graph.position(graph.blocks().nearest(places[far[k]]));
  std::vector<SurfaceFoot> moved;
  for (int round = 0; round < rounds && !far.empty(); ++round) {
    surface.project(queries, moved);
    for (std::size_t k = 0; k < far.size(); ++k) {
      feet[far[k]] = moved[k];
      Vector3d off = places[far[k]] - moved[k].position;
      off -= moved[k].normal * moved[k].normal.dot(off);
      const double most = 2.0 * graph.spacing();
      queries[k] = moved[k].position + (off.norm() > most ? Vector3d(off * (most / off.norm())) : off);
    }
  }
  return feet;
}

/** Interpolate between the known axes before and after, by their distance in points; copy if there is only one. */
std::size_t
fillAxes(DrivePass& pass, const std::uint8_t* known)
{
  const std::size_t n = pass.points.size();
  std::size_t filled = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (known[i])
      continue;
    ++filled;
    const std::size_t reach = pass.closed ? n : 0;
    std::size_t before = 1, after = 1;
    const auto end = [&](std::size_t steps, bool back) { return pass.closed ? steps >= reach : back ? steps > i : i + steps >= n; };
    while (!end(before, true) && !known[(i + n - before) % n])
      ++before;
    while (!end(after, false) && !known[(i + after) % n])
      ++after;
    const Vector3d a = end(before, true) ? Vector3d(Vector3d::Zero()) : pass.points[(i + n - before) % n].axis;
    const Vector3d b = end(after, false) ? Vector3d(Vector3d::Zero()) : pass.points[(i + after) % n].axis;
    const Vector3d mean = a * static_cast<double>(after) + b * static_cast<double>(before);
    pass.points[i].axis = mean.norm() > 1e-6 ? Vector3d(mean.normalized()) : a;
  }
  return filled;
}

Status
setSurfaceNormals(const SurfaceGraph& graph, const Pointers& points, const ProgressCallback& progress, DrivePasses& passes,
                  DriveReport& report)
{
  constexpr std::size_t at_a_time = 20000;
  const MlsSurface surface(graph);
  std::vector<std::uint8_t> known;
  for (std::size_t first = 0; first < points.size(); first += at_a_time) {
    if (progress && !progress(static_cast<double>(first) / static_cast<double>(points.size()), "axes"))
      return {StatusCode::Cancelled, "cancelled"};
    const Pointers some(points.begin() + first, points.begin() + std::min(points.size(), first + at_a_time));
    const std::vector<SurfaceFoot> feet = feetOf(surface, some);
    for (std::size_t i = 0; i < some.size(); ++i) {
      known.push_back(feet[i].valid);
      some[i]->axis = feet[i].normal;
    }
  }
  const std::uint8_t* of_pass = known.data();
  for (DrivePass& pass : passes) {
    if (std::none_of(of_pass, of_pass + pass.points.size(), [](std::uint8_t k) { return k != 0; }))
      return {StatusCode::InvalidInput,
              Diagnostic("no surface was found next to the pass that begins at ", Place(pass.points.front().position),
                         ", so its axes cannot be surface normals; move it onto the scan, or choose another axis mode")};
    report.axes_from_neighbours += fillAxes(pass, of_pass);
    of_pass += pass.points.size();
  }
  if (report.axes_from_neighbours > 0)
    report.warnings.push_back(Diagnostic(report.axes_from_neighbours, " of ", points.size(),
                                         " drive points have no surface next to them; their axes are interpolated from those before "
                                         "and after"));
  return Status::success();
}

} // namespace

Status
setAxes(const SurfaceGraph& graph, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
        DriveReport& report)
{
  const Pointers points = pointsIn(passes);
  switch (settings.axisMode()) {
  case DriveAxisMode::Fixed:
    for (DrivePoint* p : points)
      p->axis = settings.axis.normalized();
    return Status::success();
  case DriveAxisMode::Cylinder:
    return setRadial(*report.column, points);
  case DriveAxisMode::LocalPlane:
    setPlaneNormals(graph, points);
    return Status::success();
  case DriveAxisMode::Surface:
    return setSurfaceNormals(graph, points, progress, passes, report);
  }
  return Status::success();
}

} // namespace pcl_spiral
