// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cutter/impl/location_surface.h>

#include "coordinate_rounding.h"
#include "graph/covering_radius.h"

#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double shortest_rim = 8.0; // in spacings: a shorter loop is a flaw of the triangulation

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
  noise_allowance_ = point_deviations * surface_->noise() + coordinate_rounding * magnitude;
  findRim();
  findCoveringRadii();
  findEdge();
  surface_ = Surface::withoutTriangulation(surface_);
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
    queries.reserve(points.size());
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
  constexpr int along = 8, beyond = 2, about = 8; // places per spacing, per half a spacing, and per radian about corners
  std::vector<BoundaryLoop> loops;
  if (!findBoundaryLoops(*surface_, {}, loops).ok())
    return;
  const double spacing = surface_->spacing();
  std::vector<Eigen::Vector3f> places;
  const auto add = [&](const Eigen::Vector3d& on_outline, const Eigen::Vector3d& outward) {
    for (int j = 0; j <= beyond; ++j) {
      const double out = 0.5 * spacing * j / beyond;
      places.push_back((on_outline + out * outward).cast<float>());
      outward_.push_back(outward.cast<float>());
      out_.push_back(static_cast<float>(out));
    }
  };
  for (const BoundaryLoop& loop : loops) {
    if (loop.type == LoopType::ScanGap)
      continue;
    std::vector<SurfaceFoot> feet;
    surface_->fit().project(loop.curve, feet);
    const std::size_t count = loop.curve.size();
    const auto wayFrom = [&](std::size_t i) -> Eigen::Vector3d { return loop.curve[(i + 1) % count] - loop.curve[i]; };
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      if (!feet[i].valid || !feet[next].valid)
        continue;
      // The surface is on the left of the loop.
      const Eigen::Vector3d way = wayFrom(i), before = wayFrom((i + count - 1) % count), normal = feet[i].normal;
      const double turn = std::atan2(before.cross(way).dot(normal), before.dot(way));
      const int turns = static_cast<int>(about * turn); // none where the outline turns to the other side
      for (int k = 1; k <= turns; ++k)
        add(loop.curve[i], Eigen::AngleAxisd(turn * k / (turns + 1), normal) * before.cross(normal).normalized());
      const int steps = std::max(1, static_cast<int>(std::ceil(along * way.norm() / spacing)));
      for (int k = 0; k < steps; ++k) {
        const double f = static_cast<double>(k) / steps;
        add(loop.curve[i] + f * way, way.cross((1.0 - f) * normal + f * feet[next].normal).normalized());
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
    const auto radius =
        static_cast<float>(coveringRadiusOf(graph.position(corner[0]), graph.position(corner[1]), graph.position(corner[2])));
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
