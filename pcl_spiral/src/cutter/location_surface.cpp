// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cutter/impl/location_surface.h>

#include "coordinate_rounding.h"

#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
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
  findEdge();
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

const PointBlocks&
LocationSurface::feet() const
{
  std::call_once(feet_once_, [this] {
    const std::vector<Eigen::Vector3f>& points = surface_->graph().blocks().points();
    std::vector<Eigen::Vector3d> queries;
    for (const Eigen::Vector3f& point : points)
      queries.push_back(point.cast<double>());
    std::vector<SurfaceFoot> found;
    surface_->fit().project(queries, found);
    std::vector<Eigen::Vector3f> places = points;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (found[i].valid)
        places[i] = found[i].position.cast<float>();
    feet_ = PointBlocks(std::move(places));
  });
  return feet_;
}

double
LocationSurface::beyondOutline(const Eigen::Vector3d& place) const
{
  if (edge_.size() == 0)
    return -std::numeric_limits<double>::infinity();
  const std::uint32_t near = edge_.nearest(place), i = edge_.originalIndex(near);
  return out_[i] + (place - edge_.position(near)).dot(outward_[i].cast<double>());
}

void
LocationSurface::findEdge()
{
  constexpr int along = 8, beyond = 2; // places per spacing, and per half a spacing
  std::vector<BoundaryLoop> loops;
  if (!findBoundaryLoops(*surface_, {}, loops).ok())
    return;
  const double spacing = surface_->spacing();
  std::vector<Eigen::Vector3f> places;
  for (const BoundaryLoop& loop : loops) {
    if (loop.type == LoopType::ScanGap)
      continue;
    std::vector<SurfaceFoot> feet;
    surface_->fit().project(loop.curve, feet);
    for (std::size_t i = 0; i < loop.curve.size(); ++i) {
      const std::size_t next = (i + 1) % loop.curve.size();
      if (!feet[i].valid || !feet[next].valid)
        continue;
      const Eigen::Vector3d way = loop.curve[next] - loop.curve[i];
      const int steps = std::max(1, static_cast<int>(std::ceil(along * way.norm() / spacing)));
      for (int k = 0; k < steps; ++k) {
        const double f = static_cast<double>(k) / steps;
        const Eigen::Vector3d normal = (1.0 - f) * feet[i].normal + f * feet[next].normal;
        const Eigen::Vector3d outward = way.cross(normal).normalized(); // the surface is on the left of the loop
        for (int j = 0; j <= beyond; ++j) {
          const double out = 0.5 * spacing * j / beyond;
          places.push_back((loop.curve[i] + f * way + out * outward).cast<float>());
          outward_.push_back(outward.cast<float>());
          out_.push_back(static_cast<float>(out));
        }
      }
    }
  }
  edge_ = PointBlocks(std::move(places));
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
