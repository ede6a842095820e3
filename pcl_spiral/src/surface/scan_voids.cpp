// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/surface/impl/scan_voids.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double widest_chance = 1.6;        // spacings: triangles with an empty circle of at least this radius are checked
constexpr double rarity = 9.0;               // added to ln n
const double hexagon = std::sqrt(3.0) / 2.0; // area per point over the square of the spacing, as if spread evenly
constexpr double inner_share = 0.95;         // of the radius of a disc: a place closer to its edge is beside points of the scan

Eigen::Vector3d
circumcentre(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const Eigen::Vector3d u = b - a, v = c - a, n = u.cross(v);
  return a + (u.squaredNorm() * v.cross(n) + v.squaredNorm() * n.cross(u)) / (2.0 * n.squaredNorm());
}

/** Centre of the empty circle of triangle \p t, and its radius; infinite if it has no area. */
std::pair<Eigen::Vector3d, double>
emptyCircle(const SurfaceGraph& graph, std::size_t t)
{
  const auto& corners = graph.triangulation().triangle(t);
  const Eigen::Vector3d a = graph.position(corners[0]);
  const Eigen::Vector3d centre = circumcentre(a, graph.position(corners[1]), graph.position(corners[2]));
  return {centre, (centre - a).norm()};
}

double
triangleArea(const SurfaceGraph& graph, std::size_t t)
{
  const auto& c = graph.triangulation().triangle(t);
  return 0.5 * (graph.position(c[1]) - graph.position(c[0])).cross(graph.position(c[2]) - graph.position(c[0])).norm();
}

/** Mean area per point, mm2, among the points some rings away from the cluster: the void itself makes spacings large. */
double
shareAbout(const SurfaceGraph& graph, const std::vector<std::uint32_t>& cluster)
{
  constexpr int rings = 3;
  const Triangulation& triangles = graph.triangulation();
  std::vector<std::uint32_t> front, seen;
  for (const std::uint32_t t : cluster)
    for (const std::uint32_t v : triangles.triangle(t))
      front.push_back(v);
  const auto tidy = [](std::vector<std::uint32_t>& points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
  };
  tidy(front);
  for (int ring = 0; ring < rings; ++ring) {
    seen.insert(seen.end(), front.begin(), front.end());
    tidy(seen);
    std::vector<std::uint32_t> next;
    for (const std::uint32_t v : front)
      for (std::uint32_t i = triangles.outgoingBegin(v); i < triangles.outgoingBegin(v + 1); ++i)
        if (const std::uint32_t w = triangles.target(triangles.outgoing(i)); !std::binary_search(seen.begin(), seen.end(), w))
          next.push_back(w);
    if (next.empty())
      break;
    front = std::move(next);
    tidy(front);
  }
  double sum = 0.0;
  for (const std::uint32_t v : front)
    sum += graph.spacing(v) * graph.spacing(v);
  return hexagon * sum / static_cast<double>(front.size());
}

/** Triangles with an empty circle wider than chance often makes. */
std::vector<std::uint8_t>
wideTriangles(const SurfaceGraph& graph)
{
  std::vector<std::uint8_t> wide(graph.triangulation().triangleCount());
  const auto count = static_cast<std::int64_t>(wide.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t t = 0; t < count; ++t) {
    const double radius = emptyCircle(graph, t).second;
    wide[t] = radius > widest_chance * graph.spacing(graph.triangulation().triangle(t)[0]);
  }
  return wide;
}

/** The wide triangles joined to \p first by common edges. They are removed from \p wide. */
std::vector<std::uint32_t>
cluster(const Triangulation& triangles, std::uint32_t first, std::vector<std::uint8_t>& wide)
{
  std::vector<std::uint32_t> found{first};
  wide[first] = 0;
  for (std::size_t k = 0; k < found.size(); ++k)
    for (std::uint32_t h = 3 * found[k]; h < 3 * found[k] + 3; ++h) {
      const std::uint32_t other = triangles.opposite(h);
      if (other == Triangulation::none || !wide[other / 3])
        continue;
      wide[other / 3] = 0;
      found.push_back(other / 3);
    }
  std::sort(found.begin(), found.end());
  return found;
}

/** Middle and extent of the circles about as wide as the widest; other triangles come from chance. */
ScanVoid
measured(const SurfaceGraph& graph, std::vector<std::uint32_t> triangles)
{
  constexpr double as_wide = 0.7;
  std::vector<std::pair<Eigen::Vector3d, double>> circles;
  double widest = 0.0, area = 0.0;
  for (const std::uint32_t t : triangles) {
    circles.push_back(emptyCircle(graph, t));
    widest = std::max(widest, circles.back().second);
  }
  ScanVoid found;
  for (std::size_t i = 0; i < circles.size(); ++i)
    if (circles[i].second >= as_wide * widest) {
      found.place += triangleArea(graph, triangles[i]) * circles[i].first;
      area += triangleArea(graph, triangles[i]);
    }
  found.place /= area;
  for (const auto& [centre, radius] : circles)
    if (radius >= as_wide * widest)
      found.width = std::max(found.width, 2.0 * ((centre - found.place).norm() + radius));
  found.triangles = std::move(triangles);
  return found;
}

/** Whether one of \p cluster lies at the edge of the surface, where circles reach beyond it. */
bool
touchesEdge(const Triangulation& triangles, const std::vector<std::uint32_t>& cluster)
{
  for (const std::uint32_t t : cluster)
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
      if (triangles.opposite(h) == Triangulation::none)
        return true;
  return false;
}

/** Whether \p triangles cover more than chance leaves empty. */
bool
isVoid(const SurfaceGraph& graph, const std::vector<std::uint32_t>& triangles)
{
  if (touchesEdge(graph.triangulation(), triangles))
    return false;
  double largest_circle = 0.0, together = 0.0; // in areas per point
  const double share = shareAbout(graph, triangles);
  for (const std::uint32_t t : triangles) {
    const double radius = emptyCircle(graph, t).second;
    largest_circle = std::max(largest_circle, pi * radius * radius / share);
    together += triangleArea(graph, t) / share;
  }
  return std::max(largest_circle, together) > std::log(static_cast<double>(graph.size())) + rarity;
}

} // namespace

ScanVoids::ScanVoids(const SurfaceGraph& graph)
{
  std::vector<std::uint8_t> wide = wideTriangles(graph);
  for (std::uint32_t t = 0; t < wide.size(); ++t)
    if (wide[t])
      if (std::vector<std::uint32_t> found = cluster(graph.triangulation(), t, wide); isVoid(graph, found)) {
        voids_.push_back(measured(graph, std::move(found)));
        addDiscs(graph, voids_.back());
      }
  std::sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) { return std::tie(a.point, a.disc) < std::tie(b.point, b.disc); });
}

void
ScanVoids::addDiscs(const SurfaceGraph& graph, const ScanVoid& found)
{
  for (const std::uint32_t t : found.triangles) {
    const std::pair<Eigen::Vector3d, double> circle = emptyCircle(graph, t); // clang 14 has no captures of structured bindings
    const Eigen::Vector3d& centre = circle.first;
    const double reach = 1.5 * circle.second; // of the point nearest to a place within
    Box box;
    const Eigen::Vector3f place = centre.cast<float>();
    box.extend(place.data());
    graph.blocks().forBlocksNear(box, static_cast<float>(reach * reach), [&](std::size_t block) {
      for (std::size_t i = graph.blocks().blockBegin(block); i < graph.blocks().blockEnd(block); ++i)
        if ((graph.position(i) - centre).norm() <= reach)
          near_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(discs_.size())});
    });
    discs_.push_back({centre, circle.second});
  }
}

bool
ScanVoids::contains(const Eigen::Vector3d& place, std::uint32_t nearest) const
{
  const auto first =
      std::lower_bound(near_.begin(), near_.end(), nearest, [](const Near& near, std::uint32_t point) { return near.point < point; });
  for (auto near = first; near != near_.end() && near->point == nearest; ++near)
    if ((place - discs_[near->disc].centre).norm() < inner_share * discs_[near->disc].radius)
      return true;
  return false;
}

} // namespace pcl_spiral
