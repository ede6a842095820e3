// SPDX-License-Identifier: BSD-3-Clause
#include "support/sampling.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral::test {

namespace {

/** Upper bound of the area element, from a grid over the region with a margin. */
double
largestAreaElement(const AnalyticSurface& surface)
{
  const Eigen::Vector2d lower = surface.region().lower(), upper = surface.region().upper();
  double largest = 0.0;
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; j <= 200; ++j) {
      const Eigen::Vector2d u = lower + (upper - lower).cwiseProduct(Eigen::Vector2d(i, j) / 200.0);
      const double element = surface.areaElement(u);
      if (std::isfinite(element) && surface.region().contains(u))
        largest = std::max(largest, element);
    }
  return 1.1 * largest;
}

} // namespace

double
Random::normal()
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * pi * uniform());
}

Sampled
sampleUniform(const AnalyticSurface& surface, std::size_t count, std::uint64_t seed)
{
  const Region& region = surface.region();
  const double largest = largestAreaElement(surface);
  Random random(seed);
  Sampled result;
  while (result.points.size() < count) {
    const double u = random.uniform(region.lower().x(), region.upper().x());
    const double v = random.uniform(region.lower().y(), region.upper().y());
    const double level = random.uniform() * largest;
    if (!region.contains({u, v}) || level > surface.areaElement({u, v}))
      continue;
    result.points.push_back(surface.lift({u, v}));
    result.normals.push_back(surface.normal(result.points.back()));
  }
  return result;
}

Sampled
sampleScanLines(const AnalyticSurface& surface, double along, double across, std::uint64_t seed, double jitter)
{
  const Region& region = surface.region();
  Random random(seed);
  Sampled result;
  for (double v = region.lower().y() + across * random.uniform(); v < region.upper().y(); v += across)
    for (double u = region.lower().x() + along * random.uniform(); u < region.upper().x(); u += along) {
      const Eigen::Vector2d at(u + jitter * along * random.uniform(-1.0, 1.0), v);
      if (!region.contains(at))
        continue;
      result.points.push_back(surface.lift(at));
      result.normals.push_back(surface.normal(result.points.back()));
    }
  return result;
}

void
addNoise(Sampled& sampled, double sigma, std::uint64_t seed)
{
  Random random(seed);
  for (std::size_t i = 0; i < sampled.points.size(); ++i)
    sampled.points[i] += sigma * random.normal() * sampled.normals[i];
}

std::vector<std::size_t>
shuffled(std::size_t n, std::uint64_t seed)
{
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random(seed);
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

Eigen::Isometry3d
randomMotion(std::uint64_t seed, double reach)
{
  Random random(seed);
  Eigen::Vector4d q;
  for (int i = 0; i < 4; ++i)
    q[i] = random.normal();
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::Quaterniond(q).normalized().toRotationMatrix();
  for (int i = 0; i < 3; ++i)
    motion.translation()[i] = random.uniform(-reach, reach);
  return motion;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
toCloud(const std::vector<Eigen::Vector3d>& points)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  cloud->reserve(points.size());
  for (const Eigen::Vector3d& p : points)
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  return cloud;
}

pcl::PointCloud<pcl::Normal>::Ptr
toNormals(const std::vector<Eigen::Vector3d>& normals)
{
  pcl::PointCloud<pcl::Normal>::Ptr cloud(new pcl::PointCloud<pcl::Normal>);
  cloud->reserve(normals.size());
  for (const Eigen::Vector3d& n : normals)
    cloud->emplace_back(static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z()));
  return cloud;
}

} // namespace pcl_spiral::test
