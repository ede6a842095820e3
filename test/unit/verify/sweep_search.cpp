// SPDX-License-Identifier: BSD-3-Clause
// The search among the moves of any cutter, against trying every move.
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include "support/cutters.h"
#include "support/random_vectors.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sweep_search_test {

using namespace pcl_spiral;
using test::Random;
using test::randomUnit;
using test::randomVector;

namespace {

struct Way {
  Polyline tips;
  std::vector<Eigen::Vector3d> axes;
  std::vector<std::size_t> passes;
};

/** Rows over a wavy surface, or over a plane on which all tips have the same height; some moves are long, the axis leans and turns. */
Way
rows(Random& random, double radius, bool wavy)
{
  Way way;
  const double step = 0.15 * radius;
  for (int row = 0; row < 16; ++row) {
    if (row % 4 == 0 && row > 0)
      way.passes.push_back(way.tips.size());
    for (int k = 0; k < 24; ++k) {
      if (row % 5 == 0 && k > 4 && k < 16)
        continue; // one long move
      const double x = 0.1 * radius * (row % 2 == 0 ? k : 23 - k), y = step * row;
      const double z = wavy ? 0.1 * radius * std::sin(x / radius) * std::cos(y / radius) : 0.0;
      way.tips.emplace_back(x, y, z);
      const Eigen::Vector3d lean(wavy ? -0.1 * std::cos(x / radius) : 0.0, wavy ? 0.2 : 0.0, 1.0);
      way.axes.push_back(lean.normalized());
    }
  }
  if (wavy) // a few moves with a strong turn
    for (std::size_t i = 10; i < way.axes.size(); i += 60)
      way.axes[i] = (way.axes[i] + 0.5 * randomUnit(random)).normalized();
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(random.uniform(0.0, 3.0), randomUnit(random)));
  const Eigen::Vector3d off = 1e3 * randomUnit(random);
  for (std::size_t i = 0; i < way.tips.size(); ++i) {
    way.tips[i] = turn * way.tips[i] + off;
    way.axes[i] = turn * way.axes[i];
  }
  return way;
}

/** A place near the tips, and a direction near an axis. */
void
nearWay(Random& random, const Way& way, double radius, Eigen::Vector3d& x, Eigen::Vector3d& n)
{
  const std::size_t i = random.below(static_cast<unsigned int>(way.tips.size()));
  x = way.tips[i] + random.uniform(0.0, 1.2) * radius * way.axes[i].unitOrthogonal() + random.uniform(-0.1, 0.1) * radius * way.axes[i];
  n = (way.axes[i] + 0.3 * randomVector(random, 1.0)).normalized();
}

/** Counts the moves that a search tries. */
class CountingSweep : public ProfileSweep {
public:
  using ProfileSweep::ProfileSweep;
  bool enter(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const override
  {
    ++tried;
    return ProfileSweep::enter(move, x, n, start, t);
  }
  mutable std::size_t tried = 0;
};

} // namespace

TEST(SweepSearch, FindsWhatTryingEveryMoveFinds)
{
  Random random(1);
  int met = 0, deep = 0, other = 0;
  for (int part = 0; part < 24; ++part) {
    const CutterShape cutter = test::randomCutter(random);
    const Way way = rows(random, cutter.radius, part % 3 != 0);
    const ProfileSweep sweep(cutter, way.tips, way.axes, way.passes);
    const double reach = 0.2 * cutter.radius;
    for (int k = 0; k < 150; ++k) {
      Eigen::Vector3d x, n;
      nearWay(random, way, cutter.radius, x, n);
      const double start = k % 4 == 0 ? 2.0 * sweep.boundingRadius() : random.uniform(0.0, 0.1) * cutter.radius;
      double first = reach, most = 0.0;
      std::size_t own = 0;
      for (std::size_t i = 0; i < sweep.moves(); ++i) {
        if (sweep.enter(i, x, n, start, first))
          own = i;
        most = std::max(most, sweep.depth(i, x));
      }
      Stock stock;
      stock.height = reach;
      sweep.enterAny(x, n, start, stock);
      ASSERT_EQ(stock.met, first < reach) << part << ' ' << k;
      ASSERT_NEAR(stock.height, first, 5e-8) << part << ' ' << k;
      ASSERT_NEAR(sweep.deepest(x), most, 1e-9) << part << ' ' << k;
      if (stock.met) { // the move named is the one that cuts there
        double alone = reach;
        ASSERT_TRUE(sweep.enter(stock.move, x, n, start, alone));
        ASSERT_NEAR(alone, stock.height, 5e-8);
        other += stock.move != own;
      }
      met += stock.met;
      deep += most > 0.0;
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(deep, 500);
  EXPECT_LT(other, met / 2);
}

TEST(SweepSearch, TestsFewMovesOfALongPath)
{
  // Rows of a bull-nose that leans to their side on a dome: what a query costs must not grow with the path.
  const CutterShape cutter = CutterShape::bullNose(10.0, 2.0);
  constexpr double dome = 300.0, lean = 0.26, step = 2.0;
  const auto triedPerQuery = [&](int count) {
    Way way;
    std::vector<Eigen::Vector3d> places, normals;
    for (int row = 0; row < count; ++row)
      for (int k = 0; k < count; ++k) {
        const double u = step * ((row % 2 == 0 ? k : count - 1 - k) - 0.5 * count) / dome, v = step * (row - 0.5 * count) / dome;
        normals.push_back(Eigen::Vector3d(std::tan(u), std::tan(v), 1.0).normalized());
        places.push_back(dome * normals.back());
        way.axes.push_back(Eigen::AngleAxisd(lean, Eigen::Vector3d::UnitX()) * normals.back());
        way.tips.push_back(CutterProfile(cutter).locate(places.back(), normals.back(), way.axes.back()).tip);
      }
    const CountingSweep sweep(cutter, way.tips, way.axes);
    constexpr std::size_t queries = 4000;
    for (std::size_t k = 0; k < queries; ++k) {
      const std::size_t i = k * 7919 % places.size();
      Stock stock;
      stock.height = 1.0;
      sweep.enterAny(places[i] + 0.4 * step * normals[i].unitOrthogonal(), normals[i], 0.01, stock);
      EXPECT_TRUE(stock.met);
    }
    return static_cast<double>(sweep.tried) / queries;
  };
  const double small = triedPerQuery(30), large = triedPerQuery(240); // 64 times as many moves
  EXPECT_LT(small, 40.0);
  EXPECT_LT(large, 40.0) << small;
}

} // namespace sweep_search_test
