// SPDX-License-Identifier: BSD-3-Clause
#include "empty_spheres.h"

#include <atomic>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double larger = 1.25;     // than the ball
constexpr double most_radii = 50.0; // spacings: about 2000 points beside a sphere, which take as long as fitting the surface at a point

/** Points beside one another, in arrays that the compiler can go through several at a time. */
struct Nearby {
  std::vector<float> x, y, z;

  void clear()
  {
    x.clear();
    y.clear();
    z.clear();
  }
  void add(const Eigen::Vector3f& p)
  {
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
  }
};

/** The squares of the distances from a point at which others begin to count. */
struct Limits {
  float own, least, noise;
};

/** Whether one of \p points lies in the sphere of \p radius tangent at \p p, with its centre along \p n. */
bool
holdsAny(const Nearby& points, const Eigen::Vector3f& p, const Eigen::Vector3f& n, float radius, const Limits& limits)
{
  const float *x = points.x.data(), *y = points.y.data(), *z = points.z.data();
  const float half = 0.5f / radius;
  int inside = 0;
  for (std::size_t k = 0; k < points.x.size(); ++k) {
    const float dx = x[k] - p.x(), dy = y[k] - p.y(), dz = z[k] - p.z();
    const float squared = dx * dx + dy * dy + dz * dz;
    const float depth = n.x() * dx + n.y() * dy + n.z() * dz - half * squared; // 0 on the sphere
    inside |= static_cast<int>(depth > 0.0f) & (static_cast<int>(squared > limits.own) |
                                                (static_cast<int>(squared > limits.least) & static_cast<int>(depth > limits.noise)));
  }
  return inside != 0;
}

} // namespace

bool
spheresAreEmpty(const SurfaceGraph& graph, double radius, double own, double noise)
{
  if (radius > most_radii * graph.spacing())
    return false;
  const auto r = static_cast<float>(larger * radius);
  const Limits limits{static_cast<float>(own * own), static_cast<float>(graph.spacing() * graph.spacing()), static_cast<float>(noise)};
  const PointBlocks& points = graph.blocks();
  const auto blocks = static_cast<std::int64_t>(points.blockCount());
  std::atomic<bool> empty{true};
#pragma omp parallel
  {
    Nearby nearby;
#pragma omp for schedule(dynamic, 64)
    for (std::int64_t b = 0; b < blocks; ++b) {
      if (!empty.load(std::memory_order_relaxed))
        continue;
      Box centres;
      for (std::size_t i = points.blockBegin(b); i < points.blockEnd(b); ++i)
        centres.extend(Eigen::Vector3f(points.point(i) + r * graph.normals()[i]).data());
      nearby.clear();
      points.forBlocksNear(centres, r * r, [&](std::size_t near) {
        for (std::size_t k = points.blockBegin(near); k < points.blockEnd(near); ++k)
          nearby.add(points.point(k));
      });
      for (std::size_t i = points.blockBegin(b); i < points.blockEnd(b); ++i)
        if (holdsAny(nearby, points.point(i), graph.normals()[i], r, limits)) {
          empty.store(false, std::memory_order_relaxed);
          break;
        }
    }
  }
  return empty.load();
}

} // namespace pcl_spiral
