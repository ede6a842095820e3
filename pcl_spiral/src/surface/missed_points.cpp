// SPDX-License-Identifier: BSD-3-Clause
#include "missed_points.h"
#include "common/stoppable_loop.h"
#include "core/median.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double missed_deviations = 6.0; // of the points about the fit, by their median: a point that is farther above it is missed
constexpr double missed_spacings = 0.1;   // the least such height
constexpr std::size_t every = 16;         // points whose heights tell the deviation
constexpr double scans = 50.0;            // of which one has a place where chance makes such heights
/** Mean height over the arcs from its neighbours, of the least height that counts, at which a point is fitted. At the edge of a roof the
 *  fit cuts off up to 0.7 spacings times the slope; of six neighbours four lie lower by at least half of that by the arcs. */
constexpr float worth_a_fit = 0.2f;
constexpr int least_neighbours = 3;
/** Between normals of neighbours, 30 degrees: where the surface turns more from point to point, its radius is below two spacings, and
 *  neither normals nor arcs are known. */
constexpr float least_cosine = 0.866f;

/** Standard deviation of normal \p heights, by the median of their amounts. */
double
deviationOf(std::vector<float> heights)
{
  constexpr double deviation_of_median = 1.4826; // of a normal distribution
  for (float& height : heights)
    height = std::abs(height);
  return deviation_of_median * static_cast<double>(medianOf(std::move(heights)));
}

/** No points yet. \p sample: heights of some points of \p graph. */
MissedPoints
noneMissed(const SurfaceGraph& graph, std::vector<float> sample)
{
  MissedPoints missed;
  missed.noise = deviationOf(std::move(sample));
  missed.least = std::max(missed_spacings * graph.spacing(), missed_deviations * missed.noise);
  return missed;
}

/** Point \p i and those within two edges of it. */
void
gatherAbout(const Triangulation& triangles, std::uint32_t i, std::vector<std::uint32_t>& about)
{
  about.assign(1, i);
  for (std::size_t ring = 0, begin = 0; ring < 2; ++ring)
    for (const std::size_t end = about.size(); begin < end; ++begin)
      for (std::size_t o = triangles.outgoingBegin(about[begin]); o < triangles.outgoingBegin(about[begin] + 1); ++o)
        if (const std::uint32_t j = triangles.target(triangles.outgoing(o)); std::find(about.begin(), about.end(), j) == about.end())
          about.push_back(j);
}

/** Whether the heights of \p about are larger than this noise makes them: the sum of the squares of n is chi-squared with n degrees of
 *  freedom, whose cube root is about normal (Wilson and Hilferty 1931); \p rare: its standard deviations that count. So steps and edges
 *  are found whose single points are not far from the fit, but all to their sides. */
bool
areMoreThanNoise(const std::vector<float>& heights, const std::vector<std::uint32_t>& about, double noise, double rare)
{
  double squares = 0.0;
  for (const std::uint32_t j : about)
    squares += static_cast<double>(heights[j]) * static_cast<double>(heights[j]);
  const double n = static_cast<double>(about.size()), spread = 2.0 / (9.0 * n);
  return std::cbrt(squares / (n * noise * noise)) > 1.0 - spread + rare * std::sqrt(spread);
}

/** Heights of \p points of the graph over their feet; 0 without one. */
std::vector<float>
heightsOf(const SurfaceGraph& graph, const MlsSurface& fit, const std::vector<std::uint32_t>& points)
{
  std::vector<float> heights;
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < points.size(); begin += report_chunk) {
    queries.clear();
    for (std::size_t k = begin; k < std::min(points.size(), begin + report_chunk); ++k)
      queries.push_back(graph.position(points[k]));
    fit.project(queries, feet);
    for (std::size_t k = 0; k < feet.size(); ++k)
      heights.push_back(feet[k].valid ? static_cast<float>(feet[k].normal.dot(queries[k] - feet[k].position)) : 0.0f);
  }
  return heights;
}

/** Whether point \p i stands at least \p height out of the arcs from its neighbours, in the mean, or cannot tell by them. An arc
 *  with the normals of its two ends rises from one end to the other by the mean normal along the chord. */
bool
standsOut(const SurfaceGraph& graph, std::size_t i, float height)
{
  const Triangulation& triangles = graph.triangulation();
  if (triangles.triangleCount() == 0)
    return true;
  const PointBlocks& points = graph.blocks();
  float rise = 0.0f;
  int neighbours = 0;
  for (std::size_t o = triangles.outgoingBegin(i); o < triangles.outgoingBegin(i + 1); ++o, ++neighbours) {
    const std::uint32_t j = triangles.target(triangles.outgoing(o));
    if (graph.normals()[i].dot(graph.normals()[j]) < least_cosine)
      return true;
    rise += 0.5f * (graph.normals()[i] + graph.normals()[j]).dot(points.point(i) - points.point(j));
  }
  return neighbours < least_neighbours || rise > height * static_cast<float>(neighbours);
}

void
count(double height, const Eigen::Vector3d& place, MissedPoints& missed)
{
  ++missed.count;
  if (height > missed.height) {
    missed.height = height;
    missed.place = place;
  }
}

} // namespace

void
countIfMissed(double height, const Eigen::Vector3d& place, MissedPoints& missed)
{
  if (height > missed.least)
    count(height, place, missed);
}

MissedPoints
missedPoints(const SurfaceGraph& graph, const std::vector<float>& heights)
{
  std::vector<float> sample;
  for (std::size_t i = 0; i < heights.size(); i += every)
    sample.push_back(heights[i]);
  MissedPoints missed = noneMissed(graph, std::move(sample));
  std::vector<std::uint8_t> is_missed(heights.size(), 0);
  const double noise = deviationOf(heights); // of some points it is not known well enough to judge many together
  const double rare = std::sqrt(2.0 * std::log(scans * static_cast<double>(heights.size()))); // exp(-rare^2 / 2): Chernoff's bound
#pragma omp parallel
  {
    std::vector<std::uint32_t> about;
#pragma omp for schedule(static, 4096)
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(heights.size()); ++i) {
      is_missed[i] = heights[i] > missed.least;
      if (is_missed[i] || !(heights[i] > std::max(missed_spacings * graph.spacing(), noise)))
        continue;
      gatherAbout(graph.triangulation(), static_cast<std::uint32_t>(i), about);
      is_missed[i] = areMoreThanNoise(heights, about, noise, rare);
    }
  }
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (is_missed[i])
      count(heights[i], graph.position(i), missed);
  return missed;
}

MissedPoints
missedPoints(const SurfaceGraph& graph, const MlsSurface& fit)
{
  std::vector<std::uint32_t> points;
  for (std::uint32_t i = 0; i < graph.size(); i += every)
    points.push_back(i);
  MissedPoints missed = noneMissed(graph, heightsOf(graph, fit, points));
  const auto height = worth_a_fit * static_cast<float>(missed.least);
  const auto size = static_cast<std::int64_t>(graph.size());
  std::vector<std::uint8_t> stands_out(graph.size(), 0);
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t i = 0; i < size; ++i)
    stands_out[i] = standsOut(graph, i, height);
  points.clear();
  for (std::uint32_t i = 0; i < graph.size(); ++i)
    if (stands_out[i])
      points.push_back(i);
  const std::vector<float> heights = heightsOf(graph, fit, points);
  for (std::size_t k = 0; k < points.size(); ++k)
    countIfMissed(heights[k], graph.position(points[k]), missed);
  return missed;
}

} // namespace pcl_spiral
