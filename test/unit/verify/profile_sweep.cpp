// SPDX-License-Identifier: BSD-3-Clause
// What any cutter sweeps along its moves, against the cutter tried place by place.
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include "support/cutters.h"
#include "support/random_vectors.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace profile_sweep_test {

using namespace pcl_spiral;
using test::Random;
using test::randomUnit;
using test::randomVector;

namespace {

double
topOf(const CutterShape& cutter)
{
  return std::max(CutterProfile(cutter).topHeight(), 2.0 * cutter.radius);
}

/** The largest of \p value over the shares of a move, by trying many and then halving steps about the best. */
double
largestOver(const std::function<double(double)>& value)
{
  constexpr int tries = 200;
  double best = 0.0, most = value(0.0);
  const auto tryAt = [&](double f) {
    if (const double here = f >= 0.0 && f <= 1.0 ? value(f) : -1e300; here > most) {
      most = here;
      best = f;
    }
  };
  for (int k = 1; k <= tries; ++k)
    tryAt(static_cast<double>(k) / tries);
  for (double step = 1.0 / tries; step > 1e-12; step *= 0.5) {
    const double from = best;
    tryAt(from - step);
    tryAt(from + step);
  }
  return most;
}

struct Move {
  CutterShape cutter;
  CutterPlace from, to;
};

Move
randomMove(Random& random, double turn)
{
  Move move;
  move.cutter = test::randomCutter(random);
  move.from = {randomVector(random, 1.0), randomUnit(random)};
  const double length = random.uniform(0.0, 2.0) * move.cutter.radius;
  move.to = {move.from.tip + length * randomUnit(random), (move.from.axis + turn * randomUnit(random)).normalized()};
  return move;
}

/** Depth of \p x on the move, by trying; \p capped: the top of the shank counts as a side. */
double
depthByTrying(const Move& move, const Eigen::Vector3d& x, bool capped)
{
  const CutterProfile profile(move.cutter);
  return largestOver([&](double f) {
    const CutterPlace place = test::onTheWay(move.from, move.to, f);
    const double depth = test::depthOf(x, profile, place);
    return capped ? std::min(depth, topOf(move.cutter) - (x - place.tip).dot(place.axis)) : depth;
  });
}

ProfileSweep
sweepOf(const Move& move)
{
  return ProfileSweep(move.cutter, {move.from.tip, move.to.tip}, {move.from.axis, move.to.axis});
}

/** A point near the cutter. */
Eigen::Vector3d
nearMove(Random& random, const Move& move)
{
  const CutterPlace place = test::onTheWay(move.from, move.to, random.uniform(0.0, 1.0));
  const double radius = move.cutter.radius, side = random.uniform(-1.2, 1.2) * radius;
  return place.tip + side * place.axis.unitOrthogonal() + random.uniform(-0.3, 2.0) * radius * place.axis +
         randomVector(random, 0.5 * radius);
}

} // namespace

TEST(ProfileSweep, DepthIsThatOfTheDeepestPlaceOfTheMove)
{
  Random random(1);
  for (const double turn : {0.0, 0.01, 0.3})
    for (int k = 0; k < 600; ++k) {
      const Move move = randomMove(random, turn);
      const ProfileSweep sweep = sweepOf(move);
      const double height = topOf(move.cutter);
      const Eigen::Vector3d x = nearMove(random, move);
      const double tried = depthByTrying(move, x, true);
      ASSERT_NEAR(sweep.depth(0, x), tried, 1e-7 * height + (turn > 0.0 ? 6e-4 : 0.0)) << turn << ' ' << k;
      if (turn == 0.0 && std::abs(tried) > 1e-6)
        ASSERT_EQ(sweep.contains(0, x), tried > 0.0);
    }
}

TEST(ProfileSweep, EntersWhereTheRayFirstComesInside)
{
  Random random(2);
  for (const double turn : {0.0, 0.02, 0.4}) {
    const double known = turn > 0.0 ? 6e-4 : 1e-6; // mm: of depths on a move
    int entered = 0, passed_through = 0;
    for (int k = 0; k < 1000; ++k) {
      const Move move = randomMove(random, turn);
      const ProfileSweep sweep = sweepOf(move);
      const double radius = move.cutter.radius, longest = turn > 0.1 ? 0.2 * radius : radius;
      const double start = random.uniform(0.0, 1.0) * longest, reach = random.uniform(0.0, 1.5) * longest;
      const Eigen::Vector3d x = nearMove(random, move), n = randomUnit(random);
      double t = reach;
      const bool met = sweep.enter(0, x, n, start, t);
      constexpr int stations = 60;
      double first = reach;
      for (int i = 0; i <= stations && first == reach; ++i) { // a place inside, by trying
        const double s = -start + (start + reach) * i / stations;
        if (depthByTrying(move, x + s * n, true) > known)
          first = s;
      }
      ASSERT_EQ(met, t < reach);
      ASSERT_LE(t, first + 1e-6) << turn << ' ' << k; // nothing that was found by trying is missed
      if (!met)
        continue;
      ++entered;
      ASSERT_GE(t, -start);
      ASSERT_GT(depthByTrying(move, x + t * n, true), -known) << turn << ' ' << k; // what was found is inside, and nothing before it
      if (t > -start)
        ASSERT_LT(depthByTrying(move, x + (t - 1e-4 * radius) * n, true), known) << turn << ' ' << k;
      passed_through += depthByTrying(move, x + reach * n, true) < 0.0;
    }
    EXPECT_GT(entered, 200) << turn;
    EXPECT_GT(passed_through, turn > 0.1 ? 0 : 30) << turn;
  }
}

TEST(ProfileSweep, ABallWithAFlankCutsAsTheBallDoesBelowItsMiddle)
{
  Random random(3);
  for (int k = 0; k < 500; ++k) {
    const double radius = 5.0;
    const Eigen::Vector3d a = Eigen::Vector3d::Zero(), b(random.uniform(0.0, 2.0), random.uniform(-1.0, 1.0), 0.0);
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const ProfileSweep profile(CutterShape::ball(radius, 10.0), {a, b}, {up, up});
    const BallSweep ball({a, b}, {up, up}, radius);
    const Eigen::Vector3d x(random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), random.uniform(-2.0, 4.0));
    double t = 1.0, exact = 1.0;
    const bool met = profile.enter(0, x, up, 1.0, t);
    ASSERT_EQ(ball.enter(0, x, up, 1.0, exact), met);
    ASSERT_NEAR(t, exact, 1e-7);
    if (x.z() < radius)
      ASSERT_NEAR(profile.depth(0, x), ball.depth(0, x), 1e-7);
  }
}

TEST(ProfileSweep, LowestIsTheDepthBelowAPlane)
{
  Random random(4);
  for (int k = 0; k < 300; ++k) {
    const CutterShape cutter = test::randomCutter(random);
    const Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d axis = (normal + 0.4 * randomVector(random, 1.0)).normalized();
    const CutterContact contact = CutterProfile(cutter).locate(Eigen::Vector3d::Zero(), normal, axis);
    if (!contact.touches)
      continue;
    const double deep = random.uniform(0.0, 0.02) * cutter.radius;
    const ProfileSweep sweep(cutter, {contact.tip - deep * normal, contact.tip - deep * normal}, {axis, axis});
    SurfaceFoot foot;
    foot.position = Eigen::Vector3d(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), 0.0) * cutter.radius;
    foot.normal = normal;
    foot.direction1 = Eigen::Vector3d::UnitX();
    foot.valid = true;
    const double reach = 0.1 * cutter.radius;
    double depth = 0.0; // the deepest point of the plane near the contact
    for (int i = -40; i <= 40; ++i)
      for (int j = -40; j <= 40; ++j)
        depth = std::max(depth, sweep.depth(0, Eigen::Vector3d(i, j, 0.0) * 0.001 * cutter.radius));
    const SurfaceHeight lowest = sweep.lowest(0, 0.5, foot, reach);
    ASSERT_LE(-lowest.height, deep + 1e-9) << k;
    ASSERT_GE(-lowest.height, depth - 2e-3 * reach) << k << " " << depth + lowest.height;
  }
}

} // namespace profile_sweep_test
