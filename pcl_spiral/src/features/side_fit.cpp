// SPDX-License-Identifier: BSD-3-Clause
#include "side_fit.h"

#include "core/band_system.h"
#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::array<double, 5> wavelengths{40.0, 28.0, 20.0, 14.0, 10.0}; // spacings
constexpr double final_blur = 0.08;

/** Foot of \p p on the line through a and b, as a share of the way. */
double
shareOf(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a;
  const double squared = d.squaredNorm();
  return squared > 0.0 ? (p - a).dot(d) / squared : 0.0;
}

/** Points as the edge problem wants them, without those so deep inside that they settle nothing; their shares of the
 *  side's length are where they are expected, within \p reach nodes, and then are. */
std::vector<SidePoint>
placed(const EdgeSide& side, double spacing, double blur, std::ptrdiff_t reach, std::vector<ExpectedPoint>& points)
{
  constexpr double beyond = 3.0; // nodes past an end
  const double deepest = -(2.0 + 2.0 * blur);
  const auto segments = static_cast<double>(side.segments());
  std::vector<SideFoot> feet(points.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(points.size()); ++i)
    feet[i] = footOn(side, points[i].position, std::lround(points[i].share * segments), reach);
  std::vector<SidePoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SideFoot& foot = feet[i];
    points[i].share = side.closed ? foot.place / segments : std::clamp(foot.place / segments, 0.0, 1.0);
    if (foot.offset > deepest * spacing && (side.closed || (foot.place > -beyond && foot.place < segments + beyond)))
      result.push_back({foot.place, foot.offset / spacing});
  }
  return result;
}

/** The wavelength that explains the points best, as a mean weighted by likelihood: no jumps as points move. */
double
likelyWavelength(const EdgeSide& side, const std::vector<SidePoint>& points, EdgeOptions options)
{
  const double size = length(side.nodes, side.closed) / options.spacing;
  std::array<double, wavelengths.size()> cost{};
#pragma omp parallel for schedule(dynamic, 1) firstprivate(options)
  for (int k = 0; k < static_cast<int>(wavelengths.size()); ++k) {
    options.wavelength = wavelengths[k];
    cost[k] = fitEdge(side, points, options).cost() + freedom_cost * size / wavelengths[k];
  }
  const double least = *std::min_element(cost.begin(), cost.end());
  double weights = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < wavelengths.size(); ++k) {
    const double w = std::exp(0.5 * (least - cost[k]));
    weights += w;
    sum += w * std::log(wavelengths[k]);
  }
  return std::exp(sum / weights);
}

} // namespace

SideFoot
footOn(const EdgeSide& side, const Eigen::Vector3d& point, std::ptrdiff_t expected, std::ptrdiff_t reach)
{
  const auto m = static_cast<std::ptrdiff_t>(side.nodes.size());
  const auto wrapped = [&](std::ptrdiff_t k) { return (k % m + m) % m; };
  std::ptrdiff_t from = expected - reach, to = expected + reach;
  if (!side.closed || to - from + 1 >= m) {
    from = std::max<std::ptrdiff_t>(from, 0);
    to = std::min(to, m - 1);
    from = std::min(from, to);
  }
  std::ptrdiff_t best = from;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::ptrdiff_t k = from, node = wrapped(from); k <= to; ++k, node = node + 1 < m ? node + 1 : 0) {
    const double squared = (side.nodes[node] - point).squaredNorm();
    if (squared < nearest) {
      nearest = squared;
      best = node;
    }
  }
  // The segment after the nearest node or the one before, whichever is nearer; beyond the ends of an open side, prolonged.
  const bool has_next = side.closed || best + 1 < m, has_last = side.closed || best > 0;
  std::ptrdiff_t a = has_next ? best : best - 1;
  double f = shareOf(point, side.nodes[a], side.nodes[wrapped(a + 1)]);
  if (has_next && has_last) {
    const std::ptrdiff_t last = wrapped(best - 1), next = wrapped(best + 1);
    const double after = std::max(0.0, f), before = std::min(1.0, shareOf(point, side.nodes[last], side.nodes[best]));
    const auto squared = [&](std::ptrdiff_t from, std::ptrdiff_t to, double share) {
      return (side.nodes[from] + share * (side.nodes[to] - side.nodes[from]) - point).squaredNorm();
    };
    const bool is_after = squared(best, next, after) < squared(last, best, before);
    a = is_after ? best : last;
    f = is_after ? after : before;
  }
  const std::ptrdiff_t b = wrapped(a + 1);
  SideFoot foot;
  foot.place = static_cast<double>(a) + f;
  foot.position = side.nodes[a] + f * (side.nodes[b] - side.nodes[a]);
  const double g = std::clamp(f, 0.0, 1.0);
  foot.offset = (point - foot.position).dot(((1.0 - g) * side.outward[a] + g * side.outward[b]).normalized());
  return foot;
}

void
makeEven(EdgeSide& side, double spacing)
{
  const std::vector<double> at = arcLengths(side.nodes, side.closed);
  const double steps = std::round(at.back() / (node_step * spacing));
  const auto segments = static_cast<std::size_t>(std::max(side.closed ? 8.0 : 4.0, steps));
  const std::size_t count = side.closed ? segments : segments + 1, m = side.nodes.size();
  Polyline nodes(count), normals(count);
  std::size_t j = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double s = at.back() * static_cast<double>(i) / static_cast<double>(segments);
    while (j + 2 < at.size() && at[j + 1] < s)
      ++j;
    const double ds = at[j + 1] - at[j], f = ds > 0.0 ? std::clamp((s - at[j]) / ds, 0.0, 1.0) : 0.0;
    nodes[i] = (1.0 - f) * side.nodes[j] + f * side.nodes[(j + 1) % m];
    normals[i] = ((1.0 - f) * side.normals[j] + f * side.normals[(j + 1) % m]).normalized();
  }
  side.nodes = std::move(nodes);
  side.normals = std::move(normals);
  side.outward.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t a = i > 0 ? i - 1 : side.closed ? count - 1 : 0;
    const std::size_t b = i + 1 < count ? i + 1 : side.closed ? 0 : count - 1;
    side.outward[i] = (side.nodes[b] - side.nodes[a]).cross(side.normals[i]).normalized();
  }
}

EdgeSide
smoothSide(const Polyline& line, bool closed, double spacing)
{
  constexpr double wavelength = 8.0;
  constexpr std::array<double, 4> binomial{-1.0, 3.0, -3.0, 1.0};
  EdgeSide side;
  side.closed = closed;
  const double whole = length(line, closed);
  const double steps = std::max(closed ? 8.0 : 4.0, std::round(whole / (node_step * spacing)));
  Polyline even = resampled(line, static_cast<std::size_t>(steps) + (closed ? 0 : 1), closed);
  const std::size_t m = even.size();
  const double weight = std::pow(wavelength * spacing * steps / (2.0 * pi * whole), 6);
  BandSystem system(m, 3, closed);
  for (std::size_t i = 0; i < m; ++i)
    system.add(i, i, 1.0);
  for (std::size_t r = 0; r < (closed ? m : m - 3); ++r)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        system.add((r + i) % m, (r + j) % m, weight * binomial[i] * binomial[j]);
  system.solve(even);
  side.nodes = std::move(even);
  return side;
}

void
layOnSurface(const MlsSurface& surface, EdgeSide& side)
{
  const SurfaceGraph& graph = surface.graph();
  std::vector<SurfaceFoot> feet;
  surface.project(side.nodes, feet);
  side.normals.resize(side.nodes.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(side.nodes.size()); ++i) {
    if (feet[i].valid)
      side.nodes[i] = feet[i].position;
    side.normals[i] = feet[i].valid ? feet[i].normal : graph.normal(graph.blocks().nearest(side.nodes[i]));
  }
}

FittedSide
fitSide(const MlsSurface& surface, double spacing, EdgeSide start, std::vector<ExpectedPoint> points, double ring)
{
  constexpr double largest_move = 4.0, largest_growth = 3.0;
  constexpr std::ptrdiff_t first_reach = 40, reach = 12; // nodes
  constexpr std::array<double, 5> blurs{0.5, 0.25, 0.12, final_blur, final_blur};
  FittedSide fitted;
  fitted.side = std::move(start);
  const EdgeSide first = fitted.side;
  const double longest = largest_growth * ring;
  EdgeOptions options;
  options.spacing = spacing;
  options.wavelength = wavelengths[2];
  for (std::size_t round = 0; round < blurs.size(); ++round) {
    if (round == 0 || round == 3)
      layOnSurface(surface, fitted.side);
    makeEven(fitted.side, spacing);
    options.blur = blurs[round];
    const std::vector<SidePoint> near = placed(fitted.side, spacing, options.blur, round == 0 ? first_reach : reach, points);
    if (round == 2)
      options.wavelength = likelyWavelength(fitted.side, near, options);
    const EdgeFit edge = fitEdge(fitted.side, near, options);
    for (std::size_t i = 0; i < edge.offsets.size(); ++i)
      fitted.side.nodes[i] += spacing * std::clamp(edge.offsets[i], -largest_move, largest_move) * fitted.side.outward[i];
    if (!(length(fitted.side.nodes, fitted.side.closed) < longest)) { // to and fro, further every round: no smooth side
      fitted.side = first;
      layOnSurface(surface, fitted.side);
      fitted.outside = std::numeric_limits<double>::infinity();
      break;
    }
    fitted.outside = edge.outside;
    fitted.roughness = edge.roughness;
  }
  makeEven(fitted.side, spacing);
  fitted.wavelength = options.wavelength;
  return fitted;
}

} // namespace pcl_spiral
