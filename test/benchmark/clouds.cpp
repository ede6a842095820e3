// SPDX-License-Identifier: BSD-3-Clause
#include "clouds.h"

#include "support/sampling.h"

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cmath>

namespace pcl_spiral::benchmarks {

namespace {

constexpr std::uint64_t seed = 1;

/** 5 to 20 mm to one of both sides, with uniform probability. */
double
echoDistance(test::Random& random)
{
  const double side = random.uniform(-1.0, 1.0);
  return std::copysign(5.0 + 15.0 * std::abs(side), side);
}

} // namespace

test::SurfacePtr
domeSurface()
{
  return test::spheroidCap(1650.0, 860.0);
}

Points
sampledPoints(const CloudPlan& plan)
{
  const test::Sampled sampled = test::sampleUniform(*plan.surface, plan.points, seed);
  test::Random random(seed + 1000);
  Points points;
  points.reserve(plan.points);
  for (std::size_t i = 0; i < plan.points; ++i) {
    const bool echo = plan.false_echoes > 0.0 && random.uniform() < plan.false_echoes;
    const double error = echo ? echoDistance(random) : plan.noise > 0.0 ? plan.noise * random.normal() : 0.0;
    points.push_back((sampled.points[i] + error * sampled.normals[i]).cast<float>());
  }
  return points;
}

Points
inSpatialOrder(const Points& points)
{
  return PointBlocks(points).points();
}

Cloud::Ptr
toCloud(const Points& points)
{
  Cloud::Ptr cloud(new Cloud);
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& p : points)
    cloud->emplace_back(p.x(), p.y(), p.z());
  return cloud;
}

std::string
sizeName(std::size_t points)
{
  if (points % 1000000 == 0)
    return std::to_string(points / 1000000) + "M";
  return std::to_string(points / 1000) + "k";
}

} // namespace pcl_spiral::benchmarks
