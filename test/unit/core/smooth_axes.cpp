// SPDX-License-Identifier: BSD-3-Clause
// What is told of the axes of a path, against the angles of all points.
#include "core/smooth_axes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace smooth_axes_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

double
angleBetween(const Vector3d& a, const Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** Axes that turn by up to \p largest about random directions, on moves of 0 to 2 mm; some moves have no length. */
struct RandomPath {
  Polyline points{Vector3d::Zero()};
  std::vector<Vector3d> axes{Vector3d::UnitZ()};

  RandomPath(std::size_t count, double largest)
  {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> normal;
    while (points.size() < count) {
      const Vector3d about = axes.back().cross(Vector3d(normal(random), normal(random), normal(random))).normalized();
      const double step = share(random) < 0.1 ? 0.0 : 2.0 * share(random);
      points.push_back(points.back() + Vector3d(step, 0.0, 0.0));
      axes.push_back((Eigen::AngleAxisd(largest * share(random), about) * axes.back()).normalized());
    }
  }
};

} // namespace

TEST(SmoothAxes, FiguresAreTheLargestOfAllPoints)
{
  for (const double largest : {1e-4, 0.01, 0.5, M_PI}) {
    const RandomPath path(20000, largest);
    const double allowed = 0.3 * largest;
    const SmoothAxes smooth = smoothAxes(path.points, path.axes, {0.8, allowed, 0.0});
    double deviation = 0.0, change = 0.0, rate = 0.0;
    std::size_t deviating = 0;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const double off = angleBetween(smooth.axes[i], path.axes[i]);
      deviation = std::max(deviation, off);
      deviating += off > allowed;
      if (i == 0)
        continue;
      const double turn = angleBetween(smooth.axes[i - 1], smooth.axes[i]), step = (path.points[i] - path.points[i - 1]).norm();
      change = std::max(change, turn);
      if (step > 0.0)
        rate = std::max(rate, turn / step);
    }
    EXPECT_NEAR(smooth.largest_deviation, deviation, 1e-9 * deviation) << largest;
    EXPECT_NEAR(smooth.largest_change, change, 1e-9 * change) << largest;
    EXPECT_NEAR(smooth.largest_rate, rate, 1e-6 * rate) << largest; // steps are differences of arc lengths
    EXPECT_EQ(smooth.deviating_points, deviating) << largest;
    EXPECT_GT(deviating, 0u) << largest;
  }
}

TEST(SmoothAxes, MovesThatTurnFasterAreThoseOfWhichTheAngleIsLarger)
{
  for (const double largest : {1e-4, 0.01, 0.5, M_PI}) {
    const RandomPath path(20000, largest);
    const double rate = 0.5 * largest;
    std::size_t faster = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
      faster += angleBetween(path.axes[i - 1], path.axes[i]) > std::min(M_PI, rate * (path.points[i] - path.points[i - 1]).norm());
    EXPECT_EQ(movesTurningFaster(path.points, path.axes, rate), faster) << largest;
    EXPECT_GT(faster, 1000u);
    EXPECT_LT(faster, 19000u);
  }
}

} // namespace smooth_axes_test
