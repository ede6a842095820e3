// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/impl/ball_reach.h>

#include <pcl_spiral/core/impl/tolerances.h>

#include "common/stoppable_loop.h"
#include "empty_spheres.h"
#include "graph/covering_radius.h"
#include "missed_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace pcl_spiral {
namespace {

constexpr double patch_spacings = 0.75; // half the width of a patch: neighbouring patches overlap
constexpr double own_spacings = 2.5;    // radius about a foot within which fits of neighbouring points share most of their points
constexpr double own_deviations = 6.0;  // about a foot, where neighbouring patches differ by the noise of both
constexpr double own_steps = 0.1;       // spacings: steps between them without noise, at the ends of fillets
constexpr double widest_void = 6.0;     // spacings: twice the largest circle without points that is surface, alpha 3
constexpr int widest_search = 4;        // of the fit in a void, as for the path there
constexpr int most_shrinks = 40;        // of the ball at one foot; a few are usual
constexpr double settled = 1e-4;        // of the radius: the ball shrinks no more
constexpr std::size_t sample = 4096;    // points that show whether too few are reached
constexpr double surely = 5.0;          // standard deviations of a share of the sample, at most 0.5 / sqrt(size)

/** Area about each point: a third of its triangles; without triangles the square of its spacing. */
std::vector<float>
pointAreas(const SurfaceGraph& graph)
{
  std::vector<float> areas(graph.size(), 0.0f);
  const Triangulation& triangles = graph.triangulation();
  for (std::size_t t = 0; t < triangles.triangleCount(); ++t) {
    const auto& [a, b, c] = triangles.triangle(t);
    const Eigen::Vector3d ab = graph.position(b) - graph.position(a), ac = graph.position(c) - graph.position(a);
    const auto third = static_cast<float>(ab.cross(ac).norm() / 6.0);
    for (const std::uint32_t corner : triangles.triangle(t))
      areas[corner] += third;
  }
  if (triangles.triangleCount() == 0)
    for (std::size_t i = 0; i < areas.size(); ++i)
      areas[i] = static_cast<float>(graph.spacing(i) * graph.spacing(i));
  return areas;
}

bool
isNear(const PointBlocks& points, const Eigen::Vector3d& place, double distance)
{
  return points.size() > 0 && (points.position(points.nearest(place)) - place).norm() <= distance;
}

/** By how much a patch of half the width \p widest may be nearer to a place at \p distance than its foot is. */
double
nearerBy(double distance, double widest)
{
  const double sideways = 1.5 * widest;
  return std::min(sideways, sideways * sideways / (2.0 * distance));
}

} // namespace

double
reachTolerance(const MlsSurface& fit, double least)
{
  return std::max(least, fit_deviations * fit.fitNoise());
}

BallReach::BallReach(const SurfaceGraph& graph, const MlsSurface& fit, double radius, double tolerance, const BallObstacles& obstacles,
                     const std::vector<SurfacePatch>& beyond, double least_reached)
: graph_(graph), fit_(fit), size_(graph.size()), looked_(size_), radius_(radius), tolerance_(std::min(tolerance, 0.1 * radius)),
  own_(own_spacings * graph.spacing()), own_tolerance_(std::max(own_deviations / fit_deviations * tolerance_, own_steps * graph.spacing())),
  side_(graph.meanNormal())
{
  if (obstacles.points.empty() && beyond.empty() && spheresAreEmpty(graph, radius_, own_, 0.5 * tolerance_)) {
    missed_ = missedPoints(graph, fit);
    if (missed_.count == 0) {
      dropTriangulation();
      return;
    } // else an edge that the points do not show well: the fit decides
  }
  std::call_once(are_fitted_, [&] {
    std::vector<float> heights;
    patches_ = fitPatches(beyond, heights);
    missed_ = missedPoints(graph, heights);
  });
  if (!beyond.empty()) {
    std::vector<Eigen::Vector3f> feet;
    feet.reserve(beyond.size());
    for (const SurfacePatch& patch : beyond)
      feet.push_back(patch.foot.position.cast<float>());
    beyond_ = PointBlocks(std::move(feet));
  }
  setObstacles(obstacles);
  findUnreached(least_reached);
  if (looked_ == size_ && !unreached_.empty()) {
    coverVoids();
    averageNormals();
  }
  dropTriangulation();
}

void
BallReach::dropTriangulation()
{
  fit_ = fit_->withoutTriangulation();
  graph_ = fit_->graph();
}

void
BallReach::dropSurface()
{
  graph_ = SurfaceGraph();
  fit_.reset();
}

const BallReach::Patches&
BallReach::patches() const
{
  std::call_once(are_fitted_, [this] {
    std::vector<float> heights;
    patches_ = fitPatches({}, heights);
  });
  return patches_;
}

void
BallReach::coverVoids()
{
  const Triangulation& triangles = graph_.triangulation();
  const double sunk = std::sqrt(2.0 * radius_ * tolerance_); // chord from the middle at which a ball sinks by the tolerance
  const double near = 2.0 * radius_ + widest_void * graph_.spacing();
  std::vector<Eigen::Vector3d> queries;
  std::vector<double> extents;
  for (std::size_t t = 0; t < triangles.triangleCount(); ++t) {
    const auto& [a, b, c] = triangles.triangle(t);
    const Eigen::Vector3d pa = graph_.position(a), pb = graph_.position(b), pc = graph_.position(c);
    const double extent = patch_spacings * (graph_.spacing(a) + graph_.spacing(b) + graph_.spacing(c)) / 3.0;
    if (coveringRadiusOf(pa, pb, pc) <= extent + sunk || !isNearUnreached((pa + pb + pc) / 3.0, near))
      continue;
    // Cut into triangles with sides of at most two extents: the patches at the middles of those that stand as the whole one cover all.
    const double longest = std::sqrt(std::max({(pb - pa).squaredNorm(), (pc - pb).squaredNorm(), (pa - pc).squaredNorm()}));
    const auto parts = static_cast<int>(std::ceil(longest / (2.0 * extent)));
    for (int u = 0; u < parts; ++u)
      for (int v = 0; u + v < parts; ++v) {
        queries.push_back(pa + (u + 1.0 / 3.0) / parts * (pb - pa) + (v + 1.0 / 3.0) / parts * (pc - pa));
        extents.push_back(extent);
      }
  }
  if (queries.empty())
    return;
  std::vector<SurfaceFoot> feet;
  fit_->project(queries, feet, widest_search);
  const Patches& before = patches_;
  std::vector<Eigen::Vector3f> positions(before.feet.size());
  std::vector<Patch> fitted(before.feet.size());
  for (std::size_t k = 0; k < before.feet.size(); ++k) {
    positions[before.feet.originalIndex(k)] = before.feet.point(k);
    fitted[before.feet.originalIndex(k)] = before.patches[k];
  }
  for (std::size_t k = 0; k < feet.size(); ++k)
    if (feet[k].valid) {
      positions.push_back(feet[k].position.cast<float>());
      fitted.push_back(patchOf(feet[k], extents[k]));
    }
  patches_.keep(PointBlocks(std::move(positions)), fitted, graph_.size());
}

void
BallReach::Patches::keep(PointBlocks places, const std::vector<Patch>& fitted, std::size_t points)
{
  feet = std::move(places);
  patches.resize(fitted.size());
  place.resize(fitted.size());
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    patches[i] = fitted[feet.originalIndex(i)];
    place[feet.originalIndex(i)] = static_cast<std::uint32_t>(i);
    widest = std::max(widest, patches[i].extent);
  }
  place.resize(points);
}

void
BallReach::addMissed(const MlsSurface& fit, const std::vector<Eigen::Vector3f>& outliers, double most)
{
  std::vector<Eigen::Vector3d> queries;
  queries.reserve(outliers.size());
  for (const Eigen::Vector3f& outlier : outliers)
    queries.push_back(outlier.cast<double>());
  std::vector<SurfaceFoot> feet;
  fit.project(queries, feet);
  for (std::size_t i = 0; i < feet.size(); ++i)
    if (const double height = feet[i].normal.dot(queries[i] - feet[i].position); feet[i].valid && height <= most)
      countIfMissed(height, queries[i], missed_);
}

BallReach::Patch
BallReach::patchOf(const SurfaceFoot& foot, double extent)
{
  Patch patch;
  patch.extent = static_cast<float>(extent);
  patch.normal = foot.normal.cast<float>();
  patch.direction1 = foot.direction1.cast<float>();
  patch.curvature1 = static_cast<float>(foot.curvature1);
  patch.curvature2 = static_cast<float>(foot.curvature2);
  return patch;
}

BallReach::Patches
BallReach::fitPatches(const std::vector<SurfacePatch>& beyond, std::vector<float>& heights) const
{
  const std::size_t size = graph_.size();
  std::vector<Eigen::Vector3f> positions(size);
  heights.resize(size); // of the points over their feet
  std::vector<Patch> fitted(size);
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < size; begin += report_chunk) {
    queries.clear();
    for (std::size_t i = begin; i < std::min(size, begin + report_chunk); ++i)
      queries.push_back(graph_.position(i));
    fit_->project(queries, feet);
    for (std::size_t k = 0; k < feet.size(); ++k) {
      const std::size_t i = begin + k;
      const SurfaceFoot& foot = feet[k];
      const double extent = patch_spacings * graph_.spacing(i);
      positions[i] = (foot.valid ? foot.position : queries[k]).cast<float>();
      heights[i] = foot.valid ? static_cast<float>(foot.normal.dot(queries[k] - foot.position)) : 0.0f;
      SurfaceFoot flat;
      flat.normal = graph_.normal(i);
      flat.direction1 = flat.normal.unitOrthogonal();
      fitted[i] = patchOf(foot.valid ? foot : flat, extent);
    }
  }
  for (const SurfacePatch& patch : beyond) {
    positions.push_back(patch.foot.position.cast<float>());
    fitted.push_back(patchOf(patch.foot, patch.extent));
  }
  Patches patches;
  patches.keep(beyond.empty() ? PointBlocks::inOrder(std::move(positions)) : PointBlocks(std::move(positions)), fitted, size);
  return patches;
}

void
BallReach::findUnreached(double least_reached)
{
  const std::vector<std::uint8_t> empty = emptyBalls();
  if (size_ > 2 * sample && least_reached > 0.0) {
    lookAt(size_ / sample, empty);
    const auto tight = std::count_if(unreached_.begin(), unreached_.end(),
                                     [this](const UnreachedPoint& point) { return point.reach < static_cast<float>(radius_); });
    const auto all = static_cast<double>(looked_), reached = 1.0 - static_cast<double>(tight) / all;
    if (reached + surely * 0.5 / std::sqrt(all) < least_reached)
      return;
  }
  lookAt(1, empty);
}

void
BallReach::lookAt(std::size_t every, const std::vector<std::uint8_t>& empty)
{
  std::minstd_rand random; // the order of points has a pattern: the first of every few would be at the edges of blocks
  std::vector<std::uint32_t> points;
  points.reserve(size_ / every);
  for (std::size_t i = 0; i + every <= size_; i += every)
    points.push_back(static_cast<std::uint32_t>(i + (every > 1 ? random() % every : 0)));
  looked_ = points.size();
  const auto count = static_cast<std::int64_t>(looked_);
  std::vector<float> reaches(looked_);
  std::vector<std::uint8_t> covered(looked_);
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t k = 0; k < count; ++k) {
    const std::size_t i = points[k];
    reaches[k] = static_cast<float>(empty[patches_.place[i]] ? radius_ : reach(position(i), normal(i)));
    covered[k] = isCovered(i);
  }
  const auto whole = static_cast<float>(radius_);
  std::vector<float> areas;
  std::vector<Eigen::Vector3f> places;
  unreached_.clear();
  for (std::size_t k = 0; k < looked_; ++k)
    if (const std::uint32_t i = points[k]; reaches[k] < whole || covered[k] != 0) {
      if (areas.empty())
        areas = pointAreas(graph_);
      unreached_.push_back({i, reaches[k], areas[i], covered[k] != 0});
      places.push_back(patches().feet.point(patches().place[i]));
    }
  unreached_feet_ = PointBlocks(std::move(places));
}

std::vector<std::uint8_t>
BallReach::emptyBalls() const
{
  constexpr double float_error = 1e-6; // of the radius: more than the rounding of a depth
  const double within = radius_ - tolerance_;
  std::vector<Eigen::Vector3f> normals;
  std::vector<float> depths;
  normals.reserve(patches_.patches.size());
  depths.reserve(patches_.patches.size());
  for (const Patch& patch : patches_.patches) {
    const double far = within + nearerBy(within, patch.extent);
    normals.push_back(patch.normal);
    depths.push_back(static_cast<float>((radius_ * radius_ - far * far) / (2.0 * radius_) - float_error * radius_));
  }
  return emptySpheres(patches_.feet, normals, radius_, depths);
}

bool
BallReach::isNearUnreached(const Eigen::Vector3d& place, double distance) const
{
  return isNear(unreached_feet_, place, distance);
}

bool
BallReach::isNearBeyond(const Eigen::Vector3d& place, double distance) const
{
  return isNear(beyond_, place, distance);
}

bool
BallReach::isNearObstacle(const Eigen::Vector3d& place, double distance) const
{
  return isNear(obstacles_, place, distance);
}

Eigen::Vector3d
BallReach::nearestOn(const Patch& patch, const Eigen::Vector3d& foot, const Eigen::Vector3d& from)
{
  const Eigen::Vector3d n = patch.normal.cast<double>(), d1 = patch.direction1.cast<double>(), d2 = n.cross(d1);
  const Eigen::Vector3d away = from - foot;
  const double height = away.dot(n);
  const auto along = [&](double aside, double curvature) {
    const double widening = 1.0 + height * curvature; // from the patch to the parallel surface through the point
    const double t = widening > 0.05 ? aside / widening : std::copysign(1e30, aside);
    return std::clamp(t, -static_cast<double>(patch.extent), static_cast<double>(patch.extent));
  };
  const double t1 = along(away.dot(d1), patch.curvature1), t2 = along(away.dot(d2), patch.curvature2);
  return foot + t1 * d1 + t2 * d2 - 0.5 * (patch.curvature1 * t1 * t1 + patch.curvature2 * t2 * t2) * n;
}

bool
BallReach::nearestOnSurface(const Eigen::Vector3d& from, double within, Eigen::Vector3d& point, const Eigen::Vector3d* own,
                            double own_within) const
{
  if (!(within > 0.0))
    return false;
  const Patches& all = patches();
  const Eigen::Vector3f query = from.cast<float>();
  double best = within;
  bool found = false;
  double far = best + nearerBy(best, all.widest);
  all.feet.forBlocks([&](const Box& box) { return box.squaredDistance(query.data()) <= static_cast<float>(far * far); },
                     [&](std::size_t block) {
                       for (std::size_t i = all.feet.blockBegin(block); i < all.feet.blockEnd(block); ++i) {
                         if ((all.feet.point(i) - query).squaredNorm() > static_cast<float>(far * far))
                           continue;
                         const Eigen::Vector3d on = nearestOn(all.patches[i], all.feet.position(i), from);
                         const double distance = (on - from).norm();
                         if (distance >= best || (own && distance >= own_within && (on - *own).squaredNorm() < own_ * own_))
                           continue;
                         best = distance;
                         far = best + nearerBy(best, all.widest);
                         point = on;
                         found = true;
                       }
                     });
  return found;
}

double
BallReach::reach(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal) const
{
  double radius = radius_;
  Eigen::Vector3d point;
  double own_within = radius_ - own_tolerance_; // of a smaller ball, steps between the patches about the foot could be the deepest places
  for (int i = 0; i < most_shrinks && nearestOnSurface(foot + radius * normal, radius - tolerance_, point, &foot, own_within); ++i) {
    // The ball that touches at the foot and has the point as deep in it as the tolerance there.
    const Eigen::Vector3d apart = point - foot;
    const double allowed = apart.squaredNorm() < own_ * own_ ? own_tolerance_ : tolerance_;
    const double rise = apart.dot(normal) - allowed;
    const double smaller = rise > 0.0 ? (apart.squaredNorm() - allowed * allowed) / (2.0 * rise) : radius;
    if (!(smaller < radius) || !(smaller > allowed))
      break;
    own_within = 0.0;
    const bool done = radius - smaller < settled * radius;
    radius = smaller;
    if (done)
      break;
  }
  return radius;
}

} // namespace pcl_spiral
