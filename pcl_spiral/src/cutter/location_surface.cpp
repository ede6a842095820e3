// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cutter/impl/location_surface.h>

#include "coordinate_rounding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double shortest_rim = 8.0; // in spacings: a shorter loop is a flaw of the triangulation
constexpr double standard_deviations = 5.0;

double
circumradius(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a, v = c - a;
  const double twice_area = u.cross(v).norm();
  const double longest = std::sqrt(std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()}));
  if (u.dot(v) <= 0.0 || u.dot(u - v) <= 0.0 || v.dot(v - u) <= 0.0)
    return 0.5 * longest; // obtuse: all its places are nearer to a corner than the middle of the circle
  return u.norm() * v.norm() * (u - v).norm() / (2.0 * twice_area);
}

} // namespace

LocationSurface::LocationSurface(std::vector<Eigen::Vector3f> points, std::vector<std::uint32_t> source, Surface::ConstPtr surface,
                                 Status why_none)
: obstacles_(std::move(points)), source_(std::move(source)), surface_(std::move(surface)), surface_status_(std::move(why_none))
{
  measure();
}

LocationSurface::LocationSurface(const Surface::ConstPtr& surface) : surface_(surface), surface_status_(Status::success())
{
  std::vector<Eigen::Vector3f> points = surface->graph().blocks().points();
  for (std::size_t i = 0; i < surface->size(); ++i)
    source_.push_back(surface->sourceIndex(i));
  const LeftOutPoints& left_out = surface->leftOut();
  points.insert(points.end(), left_out.positions.begin(), left_out.positions.end());
  source_.insert(source_.end(), left_out.indices.begin(), left_out.indices.end());
  obstacles_ = PointBlocks(std::move(points));
  measure();
}

void
LocationSurface::measure()
{
  if (!surface_)
    return;
  double magnitude = 0.0;
  for (int d = 0; d < 3; ++d)
    magnitude = std::max<double>({magnitude, std::abs(obstacles_.box().low[d]), std::abs(obstacles_.box().high[d])});
  noise_allowance_ = standard_deviations * surface_->noise() + coordinate_rounding * magnitude;
  findRim();
  findCoveringRadii();
  dropTriangulation(surface_);
}

void
LocationSurface::findRim()
{
  const SurfaceGraph& graph = surface_->graph();
  const Triangulation& mesh = graph.triangulation();
  std::vector<Eigen::Vector3f> corners;
  for (const std::vector<std::uint32_t>& loop : mesh.boundaryLoops()) {
    double length = 0.0;
    for (const std::uint32_t h : loop)
      length += (graph.position(mesh.target(h)) - graph.position(mesh.origin(h))).norm();
    if (length > shortest_rim * graph.spacing())
      for (const std::uint32_t h : loop)
        corners.push_back(graph.blocks().point(mesh.origin(h)));
  }
  rim_ = PointBlocks(std::move(corners));
}

void
LocationSurface::findCoveringRadii()
{
  const SurfaceGraph& graph = surface_->graph();
  const Triangulation& mesh = graph.triangulation();
  std::vector<float> own(graph.size(), static_cast<float>(graph.spacing()));
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& corner = mesh.triangle(t);
    const auto radius = static_cast<float>(circumradius(graph.position(corner[0]), graph.position(corner[1]), graph.position(corner[2])));
    for (const std::uint32_t c : corner)
      own[c] = std::max(own[c], radius);
  }
  covering_radius_ = own;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    for (const std::uint32_t c : mesh.triangle(t))
      for (const std::uint32_t other : mesh.triangle(t))
        covering_radius_[c] = std::max(covering_radius_[c], own[other]);
}

} // namespace pcl_spiral
