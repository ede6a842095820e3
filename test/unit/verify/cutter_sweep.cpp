// SPDX-License-Identifier: BSD-3-Clause
// The swept ball, its index and the ridge search, against a check of every move and against exact peaks.
#include <pcl_spiral/search/impl/move_index.h>
#include <pcl_spiral/verify/impl/cutter_sweep.h>

#include "support/move_tree.h"
#include "support/random_vectors.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace cutter_sweep_test {

using namespace pcl_spiral;
using test::Random;
using test::randomUnit;
using test::randomVector;

namespace {

SurfaceFoot
footOf(const test::AnalyticSurface& surface, const Eigen::Vector3d& x, double k1, double k2)
{
  SurfaceFoot foot;
  foot.position = x;
  foot.normal = surface.normal(x);
  foot.direction1 = foot.normal.unitOrthogonal();
  foot.curvature1 = k1;
  foot.curvature2 = k2;
  foot.valid = true;
  return foot;
}

} // namespace

TEST(BallSweep, EntersWhereTheSegmentComesWithinTheRadius)
{
  Random random(1);
  int entered = 0;
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector3d a = randomVector(random, 2.0);
    const Eigen::Vector3d n = randomUnit(random);
    const Eigen::Vector3d b = k % 10 == 0 ? a : k % 10 == 1 ? Eigen::Vector3d(a + 1.5 * n) : randomVector(random, 2.0);
    const Eigen::Vector3d x = randomVector(random, 3.0);
    const BallSweep sweep({a, b}, {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}, 1.0);
    const test::MoveTree one({a, b});
    double t = 4.0;
    const bool met = sweep.enter(0, x, n, 0.5, t);
    entered += met && t > -0.5 ? 1 : 0;
    EXPECT_EQ(met, t < 4.0);
    for (double s = -0.5; s < 4.0; s += 0.01) { // outside up to there, inside just after
      const double d = one.nearest(x + s * n).first;
      if (std::abs(d - 1.0) < 1e-6)
        continue;
      EXPECT_EQ(sweep.contains(0, x + s * n), d < 1.0);
      if (s < t)
        ASSERT_GT(d, 1.0) << k << ' ' << s << ' ' << t;
      else
        break;
    }
    if (met)
      EXPECT_LE(one.nearest(x + (t + 1e-7) * n).first, 1.0 + 1e-6);
  }
  EXPECT_GT(entered, 100);
}

TEST(BallSweep, DepthIsThatBelowTheExactSurface)
{
  Random random(2);
  const double rho = 40.0, radius = 10.0;
  const test::SurfacePtr outside = test::ball(rho, test::Region({test::circle({0, 0}, 20.0)}));
  const test::SurfacePtr inside = test::bowl(rho, 20.0);
  for (int k = 0; k < 500; ++k)
    for (const bool convex : {true, false}) {
      const test::AnalyticSurface& surface = convex ? *outside : *inside;
      const double curvature = convex ? 1.0 / rho : -1.0 / rho;
      const Eigen::Vector3d x = surface.lift({random.uniform(-10, 10), random.uniform(-10, 10)});
      const Eigen::Vector3d n = (surface.normal(x) + 0.03 * randomVector(random, 1.0)).normalized();
      const Eigen::Vector3d y = surface.lift(surface.chart(x) + Eigen::Vector2d(0.5, 0.2));
      const BallSweep sweep({x, y}, {n, surface.normal(y)}, radius);
      const SurfaceFoot foot = footOf(surface, x, curvature, curvature);
      for (const double f : {0.0, 0.4, 1.0}) {
        const Eigen::Vector3d centre = (1.0 - f) * sweep.centres()[0] + f * sweep.centres()[1];
        EXPECT_NEAR(sweep.lowest(0, f, foot, rho).height, surface.signedDistance(centre) - radius, 3e-6) << convex << ' ' << f;
      }
    }
}

TEST(MoveIndex, AgreesWithTryingEveryMove)
{
  Random random(3);
  Polyline points;
  for (int i = 0; i < 600; ++i)
    points.push_back(Eigen::Vector3d(random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-3, 3)));
  for (int i = 0; i < 600; ++i) // and short moves together with the long ones
    points.push_back(points.back() + randomVector(random, 0.3));
  const double radius = 0.7, start = 0.5;
  const BallSweep sweep(points, std::vector<Eigen::Vector3d>(points.size(), Eigen::Vector3d::Zero()), radius);
  const MoveIndex index(sweep.centres());
  int met = 0;
  for (int k = 0; k < 3000; ++k) {
    const Eigen::Vector3d x(random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-9, 2));
    const Eigen::Vector3d n = randomUnit(random);
    double all = 3.0, found = 3.0, nearest = 1e9, seen = 1e9;
    for (std::size_t i = 0; i < sweep.moves(); ++i) {
      sweep.enter(i, x, n, start, all);
      nearest = std::min(nearest, test::MoveTree({points[i], points[i + 1]}).nearest(x).first);
    }
    index.search(
        x, [&] { return radius + std::max(found, start); }, [&](std::size_t move) { sweep.enter(move, x, n, start, found); });
    EXPECT_EQ(found, all);
    Eigen::Vector3d point;
    EXPECT_TRUE(index.nearest(x, seen, point));
    EXPECT_NEAR(seen, nearest, 1e-12);
    EXPECT_NEAR((point - x).norm(), nearest, 1e-12);
    met += all < 3.0 && all > -start ? 1 : 0;
  }
  EXPECT_GT(met, 300);
}

TEST(MoveIndex, FarFromTheOriginNothingIsLost)
{
  Random random(4);
  const Eigen::Vector3d far(4e5, -3e5, 1e3);
  Polyline points;
  for (int i = 0; i < 2000; ++i)
    points.push_back(far + Eigen::Vector3d(random.uniform(-50, 50), random.uniform(-50, 50), 10.0));
  const MoveIndex index(points);
  for (int k = 0; k < 200; ++k) {
    const Eigen::Vector3d p = far + randomVector(random, 60.0);
    double all = 1e9, found = 1e9;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      all = std::min(all, test::MoveTree({points[i], points[i + 1]}).nearest(p).first);
    Eigen::Vector3d point;
    index.nearest(p, found, point);
    EXPECT_NEAR(found, all, 1e-9);
  }
}

TEST(MoveIndex, ManyMovesInSeveralBlocksAndThreads)
{
  Random random(6);
  for (const std::size_t size : {2, 5, 4097, 4098, 12290}) { // blocks of 4096 moves end before, at and after the last
    Polyline points;
    while (points.size() < size)
      points.push_back(10.0 * randomVector(random, 1.0));
    if (size > 4100)
      for (const std::size_t i : {std::size_t{4095}, std::size_t{4096}, std::size_t{8191}, size - 1})
        points[i] = Eigen::Vector3d(100.0, 100.0, 0.0); // long moves, in pieces, on both sides of the blocks' ends
    const MoveIndex index(points);
    for (int k = 0; k < 30; ++k) {
      const Eigen::Vector3d p = 10.0 * randomVector(random, 1.0);
      constexpr double radius = 0.8;
      std::vector<std::uint8_t> passed(index.moves(), 0);
      index.search(
          p, [] { return radius; }, [&](std::size_t move) { passed.at(move) = 1; });
      for (std::size_t i = 0; i < index.moves(); ++i)
        ASSERT_TRUE(passed[i] || test::MoveTree({points[i], points[i + 1]}).nearest(p).first > radius) << i << " of " << size;
    }
  }
}

TEST(HeightAbove, IsTheDistanceToTheNearestPointOfTheQuadric)
{
  Random random(5);
  for (int k = 0; k < 400; ++k) {
    SurfaceFoot foot;
    foot.position = randomVector(random, 5.0);
    foot.normal = randomUnit(random);
    foot.direction1 = foot.normal.unitOrthogonal();
    foot.curvature1 = random.uniform(-0.33, 0.5); // a ball of 3 fits, sometimes only just
    foot.curvature2 = random.uniform(-0.33, foot.curvature1);
    foot.valid = true;
    const Eigen::Vector3d e2 = foot.normal.cross(foot.direction1);
    const double a = random.uniform(-1.0, 1.0), b = random.uniform(-1.0, 1.0), z = random.uniform(-1.0, 3.0);
    double nearest = 1e9;
    double reach = 12.0, u0 = a, v0 = b;
    for (int round = 0; round < 5; ++round) { // in finer steps round the best
      double best_u = u0, best_v = v0;
      for (int i = -60; i <= 60; ++i)
        for (int j = -60; j <= 60; ++j) {
          const double u = u0 + reach * i / 60.0, v = v0 + reach * j / 60.0;
          const double w = -0.5 * (foot.curvature1 * u * u + foot.curvature2 * v * v);
          const double distance = std::sqrt((a - u) * (a - u) + (b - v) * (b - v) + (z - w) * (z - w));
          if (distance < nearest) {
            nearest = distance;
            best_u = u;
            best_v = v;
          }
        }
      u0 = best_u;
      v0 = best_v;
      reach *= 0.05;
    }
    const double over = z + 0.5 * (foot.curvature1 * a * a + foot.curvature2 * b * b);
    const double height = heightAbove(foot, foot.position + a * foot.direction1 + b * e2 + z * foot.normal, 1e9).height;
    EXPECT_NEAR(std::abs(height), nearest, 1e-5) << foot.curvature1 << ' ' << foot.curvature2;
    EXPECT_EQ(height > 0.0, over > 0.0);
  }
}

TEST(HeightAbove, BeyondTheCentreOfAHollowEveryDirectionIsAsNear)
{
  SurfaceFoot foot;
  foot.curvature1 = foot.curvature2 = -0.25; // centre of curvature at 4 above it
  EXPECT_NEAR(heightAbove(foot, Eigen::Vector3d(0.0, 0.0, 3.0), 100.0).height, 3.0, 1e-6);
  // nearest to (0, 0, 6): of u^2 + (6 - u^2 / 8)^2 the least, at u^2 = 16: sqrt(32)
  EXPECT_NEAR(heightAbove(foot, Eigen::Vector3d(0.0, 0.0, 6.0), 100.0).height, std::sqrt(32.0), 1e-6);
}

} // namespace cutter_sweep_test
