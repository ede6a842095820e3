// SPDX-License-Identifier: BSD-3-Clause
// Fits with more neighbours than usual, where the nearest points do not define the surface.
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <gtest/gtest.h>

#include <random>

namespace wide_fit_test {

using Eigen::Vector3d;

/** Beside a gap some scans overlap: the nearest points are all on that side, and do not define the surface over the gap. */
TEST(WideFit, SpansAGapBesidePointsThatStandCloser)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-50.0, 50.0);
  std::vector<Eigen::Vector3f> points;
  const double radius = 200.0;
  const auto add = [&](double x, double y) { points.push_back(Vector3d(x, y, std::sqrt(radius * radius - x * x - y * y)).cast<float>()); };
  while (points.size() < 2500)
    if (const double x = u(random), y = u(random); std::abs(x) > 5.0 || std::abs(y) > 5.0)
      add(x, y);
  for (int i = 0; i < 150; ++i)
    add(5.0 + 0.02 * (u(random) + 50.0), 0.2 * u(random));
  pcl_spiral::SurfaceGraph graph;
  ASSERT_TRUE(graph.build(points, {}).ok());
  const pcl_spiral::MlsSurface surface(graph);
  for (double y = -3.0; y < 3.5; y += 1.0)
    for (double x = -3.0; x < 3.5; x += 1.0) {
      const Vector3d p(x, y, std::sqrt(radius * radius - x * x - y * y));
      std::vector<pcl_spiral::SurfaceFoot> feet;
      surface.project({p}, feet, 4);
      ASSERT_TRUE(feet[0].valid) << x << " " << y;
      EXPECT_NEAR(feet[0].position.norm(), radius, 0.05);
    }
}

} // namespace wide_fit_test
