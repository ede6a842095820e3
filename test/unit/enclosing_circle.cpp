// The smallest enclosing circle against every circle through two or three of the points.
#include "support/sampling.h"

#include <pcl_spiral/core/enclosing_circle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace pcl_spiral;
using Eigen::Vector2d;

bool
holdsAll(const Vector2d& centre, double radius, const std::vector<Vector2d>& points)
{
  return std::all_of(points.begin(), points.end(),
                     [&](const Vector2d& p) { return (p - centre).norm() <= radius * (1.0 + 1e-9); });
}

/** Smallest radius among all circles on two points as a diameter, or through three, that hold all points. */
double
smallestByTrial(const std::vector<Vector2d>& points)
{
  double best = 1e300;
  const auto offer = [&](const Vector2d& centre, double radius) {
    if (radius < best && holdsAll(centre, radius, points))
      best = radius;
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      offer(0.5 * (points[i] + points[j]), 0.5 * (points[i] - points[j]).norm());
      for (std::size_t k = 0; k < j; ++k) {
        Eigen::Matrix2d normals;
        normals << (points[j] - points[i]).transpose(), (points[k] - points[i]).transpose();
        if (std::abs(normals.determinant()) < 1e-9)
          continue;
        const Vector2d right = 0.5 * Vector2d(points[j].squaredNorm() - points[i].squaredNorm(),
                                              points[k].squaredNorm() - points[i].squaredNorm());
        const Vector2d centre = normals.inverse() * right;
        offer(centre, (points[i] - centre).norm());
      }
    }
  return best;
}

TEST(EnclosingCircle, NoneIsSmaller)
{
  test::Random random(3);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<Vector2d> points;
    const std::size_t count = 2 + random.below(18);
    while (points.size() < count)
      points.emplace_back(50.0 + 30.0 * random.normal(), -20.0 + 5.0 * random.normal());
    const Circle circle = smallestEnclosingCircle(points);
    EXPECT_TRUE(holdsAll(circle.centre, circle.radius, points));
    EXPECT_NEAR(circle.radius, smallestByTrial(points), 1e-8);
  }
}

TEST(EnclosingCircle, ManyPointsOfOneCircleInOrder)
{
  std::vector<Vector2d> points;
  for (int k = 0; k < 20000; ++k)
    points.emplace_back(7.0 + 100.0 * std::cos(k * M_PI / 1e4), -3.0 + 100.0 * std::sin(k * M_PI / 1e4));
  const Circle circle = smallestEnclosingCircle(points);
  EXPECT_NEAR(circle.radius, 100.0, 1e-8);
  EXPECT_NEAR((circle.centre - Vector2d(7.0, -3.0)).norm(), 0.0, 1e-6);
}

TEST(EnclosingCircle, FewPointsLinesAndRepeats)
{
  EXPECT_EQ(smallestEnclosingCircle({}).radius, 0.0);
  EXPECT_EQ(smallestEnclosingCircle({{4, 5}}).centre, Vector2d(4, 5));
  EXPECT_EQ(smallestEnclosingCircle({{4, 5}, {4, 5}, {4, 5}}).radius, 0.0);
  std::vector<Vector2d> line;
  for (const double t : {0.3, 0.9, -0.4, 0.1, 0.9, -1.0, 0.5})
    line.emplace_back(3.0 * t, 4.0 * t);
  const Circle circle = smallestEnclosingCircle(line);
  EXPECT_NEAR(circle.radius, 0.5 * 5.0 * 1.9, 1e-12);
  EXPECT_NEAR((circle.centre - Vector2d(-0.15, -0.2)).norm(), 0.0, 1e-12);
}

} // namespace
