// SPDX-License-Identifier: BSD-3-Clause
#include "centre_disc.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace pcl_spiral {
namespace {

constexpr double disc_in_spacings = 2.0;

/** Least of the barycentric coordinates of \p p over the triangle, seen along its normal. */
double
leastCoordinate(const SurfaceGraph& graph, std::uint32_t t, const Eigen::Vector3d& p)
{
  const auto& corner = graph.triangulation().triangle(t);
  const Eigen::Vector3d a = graph.position(corner[0]), b = graph.position(corner[1]), c = graph.position(corner[2]);
  const Eigen::Vector3d n = (b - a).cross(c - a);
  const double whole = n.squaredNorm();
  if (!(whole > 0.0))
    return -1.0;
  const double wa = (c - b).cross(p - b).dot(n) / whole, wb = (a - c).cross(p - c).dot(n) / whole;
  return std::min({wa, wb, 1.0 - wa - wb});
}

/** \p found, and the points reached from it over edges within \p radius of the centre. */
std::vector<std::uint32_t>
pointsWithin(const SurfaceGraph& graph, std::vector<std::uint32_t> found, const Eigen::Vector3d& centre, double radius)
{
  const Triangulation& mesh = graph.triangulation();
  for (std::size_t at = 0; at < found.size(); ++at)
    for (std::uint32_t k = mesh.outgoingBegin(found[at]); k < mesh.outgoingBegin(found[at] + 1); ++k) {
      const std::uint32_t v = mesh.target(mesh.outgoing(k));
      if ((graph.position(v) - centre).norm() <= radius && std::find(found.begin(), found.end(), v) == found.end())
        found.push_back(v);
    }
  return found;
}

/** The representative of \p angle nearest to \p other. */
double
continued(double angle, double other)
{
  return angle + 2.0 * pi * std::round((other - angle) / (2.0 * pi));
}

} // namespace

std::uint32_t
triangleAt(const SurfaceGraph& graph, const Eigen::Vector3d& centre)
{
  if (!centre.allFinite())
    return Triangulation::none;
  const std::uint32_t nearest = graph.blocks().nearest(centre);
  const double reach = 3.0 * std::max(graph.spacing(), graph.spacing(nearest));
  if ((graph.position(nearest) - centre).norm() > reach)
    return Triangulation::none;
  const Triangulation& mesh = graph.triangulation();
  std::uint32_t best = Triangulation::none;
  double most = -1e-6;
  for (const std::uint32_t v : pointsWithin(graph, {nearest}, centre, reach))
    for (std::uint32_t k = mesh.outgoingBegin(v); k < mesh.outgoingBegin(v + 1); ++k) {
      const std::uint32_t triangle = mesh.outgoing(k) / 3;
      const double least = leastCoordinate(graph, triangle, centre);
      if (least > most) {
        most = least;
        best = triangle;
      }
    }
  return best;
}

Status
makeCentreDisc(const SurfaceGraph& graph, std::uint32_t triangle, HarmonicDomain& domain)
{
  const Triangulation& mesh = graph.triangulation();
  const auto& corner = mesh.triangle(triangle);
  double spacing = graph.spacing();
  for (const std::uint32_t v : corner)
    spacing = std::max(spacing, graph.spacing(v));
  const double radius = disc_in_spacings * spacing;
  domain.disc = pointsWithin(graph, {corner.begin(), corner.end()}, domain.centre, radius);
  domain.in_disc.assign(graph.size(), 0);
  for (const std::uint32_t v : domain.disc)
    domain.in_disc[v] = 1;
  for (const std::uint32_t h : domain.rim)
    if (domain.in_disc[mesh.origin(h)])
      return {StatusCode::InvalidArgument,
              Diagnostic("the centre ", Place(domain.centre), " is within ", radius, " {mm} of the rim: move it inwards")};

  const Eigen::Vector3d a = graph.position(corner[0]), b = graph.position(corner[1]), c = graph.position(corner[2]);
  const Eigen::Vector3d n = (b - a).cross(c - a).normalized();
  Eigen::Vector3d e1, e2;
  tangentFrame(n, e1, e2);
  const auto direction = [&](std::uint32_t v, const Eigen::Vector3d& from) {
    const Eigen::Vector3d d = graph.position(v) - from;
    return std::atan2(d.dot(e2), d.dot(e1));
  };
  // The branch is continued over edges about a pole well inside the triangle, because the centre may lie on one of its corners.
  const Eigen::Vector3d pole = 0.8 * domain.centre + 0.2 * (a + b + c) / 3.0;
  std::unordered_map<std::uint32_t, double> about_pole{{domain.disc[0], direction(domain.disc[0], pole)}};
  std::vector<std::uint32_t> queue{domain.disc[0]};
  for (std::size_t at = 0; at < queue.size(); ++at)
    for (std::uint32_t k = mesh.outgoingBegin(queue[at]); k < mesh.outgoingBegin(queue[at] + 1); ++k) {
      const std::uint32_t h = mesh.outgoing(k), v = mesh.target(h);
      if (!domain.in_disc[v] || about_pole.count(v))
        continue;
      about_pole[v] = continued(direction(v, pole), about_pole[queue[at]]) - 2.0 * pi * domain.cut[h];
      queue.push_back(v);
    }
  domain.disc_angle.clear();
  domain.disc_radius.clear();
  for (const std::uint32_t v : domain.disc) {
    domain.disc_angle.push_back(continued(direction(v, domain.centre), about_pole[v]));
    domain.disc_radius.push_back((graph.position(v) - domain.centre).norm() / radius);
  }
  return Status::success();
}

} // namespace pcl_spiral
