// SPDX-License-Identifier: BSD-3-Clause
#include "empty_spheres.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double larger = 1.25;     // than the ball
constexpr double most_radii = 50.0; // spacings: about 2000 points beside a sphere, which take as long as fitting the surface at a point
constexpr std::size_t most_nearby = 8192; // points: to go through more takes longer than the search for one of them in a ball
constexpr float float_error = 1e-6f;      // more than the rounding of a distance

/** Points beside one another, in arrays that the compiler can go through several at a time. */
struct Nearby {
  std::vector<float> x, y, z;
  std::vector<float> limit; ///< depth at which each counts

  void clear()
  {
    for (std::vector<float>* values : {&x, &y, &z, &limit})
      values->clear();
  }
  void add(const Eigen::Vector3f& p, float depth)
  {
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
    limit.push_back(depth);
  }
};

/** The squares of the distances from a point: beyond own, others count at any depth, beyond least at their own. */
struct Limits {
  float own, least;
};

/** Whether one of \p points lies in the sphere of \p radius tangent at \p p, with its centre along \p n. */
bool
holdsAny(const Nearby& points, const Eigen::Vector3f& p, const Eigen::Vector3f& n, float radius, const Limits& limits)
{
  const float *x = points.x.data(), *y = points.y.data(), *z = points.z.data(), *limit = points.limit.data();
  const float half = 0.5f / radius;
  int inside = 0;
  for (std::size_t k = 0; k < points.x.size(); ++k) {
    const float dx = x[k] - p.x(), dy = y[k] - p.y(), dz = z[k] - p.z();
    const float squared = dx * dx + dy * dy + dz * dz;
    const float depth = n.x() * dx + n.y() * dy + n.z() * dz - half * squared; // 0 on the sphere
    inside |= (static_cast<int>(squared > limits.own) & static_cast<int>(depth > 0.0f)) |
              (static_cast<int>(squared > limits.least) & static_cast<int>(depth > limit[k]));
  }
  return inside != 0;
}

/** Calls \p visit(begin, end, nearby) for the points of each block while it returns true; \p nearby are all points that may lie within
 *  \p within of the centres of the spheres of \p radius tangent at these, on the sides of their \p normals, with their \p limit(k). In
 *  parallel. */
template <typename Limit, typename Visit>
void
forTangentSpheres(const PointBlocks& points, const std::vector<Eigen::Vector3f>& normals, float radius, float within, Limit limit,
                  Visit visit)
{
  const auto blocks = static_cast<std::int64_t>(points.blockCount());
  std::atomic<bool> goes_on{true};
#pragma omp parallel
  {
    Nearby nearby;
#pragma omp for schedule(dynamic, 64)
    for (std::int64_t b = 0; b < blocks; ++b) {
      if (!goes_on.load(std::memory_order_relaxed))
        continue;
      const std::size_t begin = points.blockBegin(b), end = points.blockEnd(b);
      Box centres;
      for (std::size_t i = begin; i < end; ++i)
        centres.extend(Eigen::Vector3f(points.point(i) + radius * normals[i]).data());
      nearby.clear();
      points.forBlocksNear(centres, within * within, [&](std::size_t near) {
        for (std::size_t k = points.blockBegin(near); k < points.blockEnd(near) && nearby.x.size() < most_nearby; ++k)
          nearby.add(points.point(k), limit(k));
      });
      if (!visit(begin, end, nearby))
        goes_on.store(false, std::memory_order_relaxed);
    }
  }
}

} // namespace

bool
spheresAreEmpty(const SurfaceGraph& graph, double radius, double own, double noise)
{
  if (radius > most_radii * graph.spacing())
    return false;
  const auto r = static_cast<float>(larger * radius), deep = static_cast<float>(noise);
  const Limits limits{static_cast<float>(own * own), static_cast<float>(graph.spacing() * graph.spacing())};
  const PointBlocks& points = graph.blocks();
  const std::vector<Eigen::Vector3f>& normals = graph.normals();
  std::atomic<bool> empty{true};
  const auto deepOf = [&](std::size_t) { return deep; };
  forTangentSpheres(points, normals, r, r, deepOf, [&](std::size_t i, std::size_t end, const Nearby& nearby) {
    while (i < end && !holdsAny(nearby, points.point(i), normals[i], r, limits))
      ++i;
    if (i < end)
      empty.store(false, std::memory_order_relaxed);
    return i == end;
  });
  return empty.load();
}

std::vector<std::uint8_t>
emptySpheres(const PointBlocks& points, const std::vector<Eigen::Vector3f>& normals, double radius, const std::vector<float>& depths)
{
  std::vector<std::uint8_t> empty(points.size(), 0);
  const auto r = static_cast<float>(radius);
  const float least = depths.empty() ? 0.0f : *std::min_element(depths.begin(), depths.end());
  const float within = std::sqrt(std::max(0.0f, r * (r - 2.0f * least))); // of a centre, where a point counts at all
  const Limits all{std::numeric_limits<float>::max(), -1.0f};
  forTangentSpheres(
      points, normals, r, within * (1.0f + float_error), [&](std::size_t k) { return depths[k]; },
      [&](std::size_t i, std::size_t end, const Nearby& nearby) {
        for (; i < end && nearby.x.size() < most_nearby; ++i)
          empty[i] = !holdsAny(nearby, points.point(i), normals[i], r, all);
        return true;
      });
  return empty;
}

} // namespace pcl_spiral
