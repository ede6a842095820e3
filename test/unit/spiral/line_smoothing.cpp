// SPDX-License-Identifier: BSD-3-Clause
// Smoothed lines stay near their input lines for any spacing of the points.
#include "spiral/lines/line_smoothing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace line_smoothing_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

ScallopLoop
loopOf(const Polyline& points)
{
  ScallopLoop loop;
  loop.points = points;
  loop.metric.assign(points.size(), StepOverMetric(Eigen::Matrix3d::Identity()));
  loop.measure();
  return loop;
}

} // namespace

TEST(LineSmoothing, CirclesKeepTheirRadius)
{
  Polyline points;
  for (int i = 0; i < 200; ++i)
    points.emplace_back(4.0 * std::cos(0.01 * M_PI * i), 4.0 * std::sin(0.01 * M_PI * i), 0.0);
  const ScallopLoop loop = loopOf(points);
  const ScallopLoop line = smoothed(loop, {std::vector<double>(200, 0.1), std::vector<double>(200, 0.4)});
  for (const Vector3d& p : line.points)
    EXPECT_NEAR(p.norm(), 4.0, 0.01);
}

TEST(LineSmoothing, PointsInClumpsThrowNoSpikes)
{
  // Points are in groups far apart, as where a loop runs over large triangles and past their corners.
  Polyline points;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 5; ++k) {
      const double a = 2.0 * M_PI * i / 40 + 4e-3 * k, r = 20.0 + (k == 2 ? 0.02 : 0.0);
      points.emplace_back(r * std::cos(a), r * std::sin(a), 0.0);
    }
  const ScallopLoop loop = loopOf(points);
  const ScallopLoop line = smoothed(loop, {std::vector<double>(points.size(), 0.9), std::vector<double>(points.size(), 1.2)});
  for (const Vector3d& p : line.points)
    EXPECT_NEAR(p.norm(), 19.97, 0.12);
}

TEST(LineSmoothing, PointsLeftOutLieBesideTheLinesThatStay)
{
  // An arc of radius 3 between straights of 10, in steps of a hundredth.
  Polyline points;
  const auto add = [&points](double x, double y) { points.emplace_back(x, y, 0.0); };
  for (int i = 0; i < 1000; ++i)
    add(0.01 * i, 0.0);
  for (int i = 0; i < 942; ++i)
    add(10.0 + 3.0 * std::sin(M_PI * i / 942), 3.0 - 3.0 * std::cos(M_PI * i / 942));
  for (int i = 0; i < 1000; ++i)
    add(10.0 - 0.01 * i, 6.0);
  const ScallopLoop loop = loopOf(points);
  const double tolerance = 0.002, longest = 0.1;
  const std::vector<std::size_t> kept = pointsKept(loop, tolerance, longest);
  ASSERT_EQ(kept.front(), 0u);
  EXPECT_LT(kept.size(), points.size() / 4);
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    const Vector3d a = points[kept[k]], b = points[kept[k + 1]];
    EXPECT_LE((b - a).norm(), longest + 1e-9);
    for (std::size_t i = kept[k]; i < kept[k + 1]; ++i)
      EXPECT_LE((b - a).normalized().cross(points[i] - a).norm(), tolerance);
  }
  std::vector<std::size_t> coarse = pointsKept(loop, tolerance, 100.0);
  EXPECT_LT(coarse.size(), kept.size());
}

} // namespace line_smoothing_test
