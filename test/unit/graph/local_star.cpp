// SPDX-License-Identifier: BSD-3-Clause
// A star follows from the circles through the point and pairs of neighbours; it also works on lattices.
#include "graph/local_star.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace local_star_test {

namespace {

struct Neighbours {
  std::vector<double> u{0.0}, v{0.0}; // the point itself first

  void add(double x, double y)
  {
    u.push_back(x);
    v.push_back(y);
  }

  int count() const { return static_cast<int>(u.size()); }

  /** Nearest first, as from the search. */
  Neighbours sorted() const
  {
    std::vector<int> order;
    for (int i = 1; i < count(); ++i)
      order.push_back(i);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return std::hypot(u[a], v[a]) < std::hypot(u[b], v[b]); });
    Neighbours result;
    for (int i : order)
      result.add(u[i], v[i]);
    return result;
  }
};

using Triangles = std::set<std::pair<int, int>>;

/** Pairs (a, b), counter-clockwise, whose circle through the point holds no other neighbour and is not too
 * large. */
Triangles
emptyCircles(const Neighbours& n, double max_circumradius)
{
  Triangles triangles;
  for (int a = 1; a < n.count(); ++a)
    for (int b = 1; b < n.count(); ++b) {
      const double turn = n.u[a] * n.v[b] - n.v[a] * n.u[b];
      if (!(turn > 0.0))
        continue;
      const double aa = n.u[a] * n.u[a] + n.v[a] * n.v[a], bb = n.u[b] * n.u[b] + n.v[b] * n.v[b];
      const double x = 0.5 * (aa * n.v[b] - bb * n.v[a]) / turn, y = 0.5 * (bb * n.u[a] - aa * n.u[b]) / turn;
      const double radius = std::hypot(x, y);
      bool empty = radius <= max_circumradius;
      for (int c = 1; c < n.count() && empty; ++c)
        empty = c == a || c == b || std::hypot(n.u[c] - x, n.v[c] - y) >= radius;
      if (empty)
        triangles.emplace(a, b);
    }
  return triangles;
}

Triangles
starTriangles(const pcl_spiral::LocalStar& star)
{
  Triangles triangles;
  const auto& spokes = star.spokes();
  for (std::size_t i = 0; i < spokes.size(); ++i)
    if (spokes[i].triangle_next)
      triangles.emplace(spokes[i].neighbour, spokes[(i + 1) % spokes.size()].neighbour);
  return triangles;
}

void
expectTurn(const pcl_spiral::LocalStar& star, const Neighbours& n)
{
  double turn = 0.0;
  const auto& spokes = star.spokes();
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const int a = spokes[i].neighbour, b = spokes[(i + 1) % spokes.size()].neighbour;
    double angle = std::atan2(n.v[b], n.u[b]) - std::atan2(n.v[a], n.u[a]);
    if (angle <= 0.0)
      angle += 2.0 * M_PI;
    turn += angle;
  }
  EXPECT_NEAR(turn, 2.0 * M_PI, 1e-9); // once round, each neighbour after the one before
}

TEST(LocalStar, TrianglesAreThoseOfEmptyCircles)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  pcl_spiral::LocalStar star;
  std::size_t seen = 0, far_neighbours = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    // Round the point, on one side of it, in a narrow wedge, stretched, with many points on one side.
    Neighbours raw;
    const int kind = trial % 5, points = 2 + trial % 47;
    for (int i = 0; i < points; ++i) {
      const double x = uniform(random), y = uniform(random);
      if (kind == 0)
        raw.add(x, y);
      else if (kind == 1)
        raw.add(std::abs(x), y);
      else if (kind == 2)
        raw.add(1.1 + x, 0.1 * y);
      else if (kind == 3)
        raw.add(x, 0.1 * y);
      else
        raw.add(i % 8 == 0 ? -std::abs(x) : 0.3 * std::abs(x), i % 8 == 0 ? y : 0.3 * y);
    }
    const Neighbours n = raw.sorted();
    for (double max_circumradius : {0.2, 5.0}) {
      star.compute(n.u.data(), n.v.data(), n.count(), max_circumradius);
      const Triangles expected = emptyCircles(n, max_circumradius);
      EXPECT_EQ(starTriangles(star), expected) << "trial " << trial;
      if (star.spokes().size() > 1)
        expectTurn(star, n);
      seen += expected.size();
      for (const auto& [a, b] : expected)
        far_neighbours += std::max(a, b) > 16;
    }
  }
  EXPECT_GT(seen, 10000u);
  EXPECT_GT(far_neighbours, 100u); // some stars reach beyond the sixteen nearest
}

TEST(LocalStar, NeighboursThatOnlyTouchACornerAreLeftOut)
{
  Neighbours square;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      if (i != 0 || j != 0)
        square.add(0.1 * i, 0.1 * j);
  const Neighbours n = square.sorted();
  pcl_spiral::LocalStar star;
  star.compute(n.u.data(), n.v.data(), n.count(), 1.0);
  ASSERT_EQ(star.spokes().size(), 4u);
  for (const auto& spoke : star.spokes()) {
    EXPECT_NEAR(std::hypot(n.u[spoke.neighbour], n.v[spoke.neighbour]), 0.1, 1e-12);
    EXPECT_TRUE(spoke.triangle_next);
  }
  EXPECT_NEAR(star.reach(), 0.1 * std::sqrt(0.5), 1e-12);
}

TEST(LocalStar, PointsAtTheSamePlaceAndNoPointsAtAll)
{
  Neighbours n;
  pcl_spiral::LocalStar star;
  star.compute(n.u.data(), n.v.data(), 1, 1.0);
  EXPECT_TRUE(star.spokes().empty());
  n.add(0.0, 0.0);
  n.add(0.0, 0.0);
  star.compute(n.u.data(), n.v.data(), 3, 1.0);
  EXPECT_TRUE(star.spokes().empty());
  for (double angle : {0.1, 2.2, 4.3})
    for (int twice = 0; twice < 2; ++twice)
      n.add(std::cos(angle), std::sin(angle));
  star.compute(n.u.data(), n.v.data(), n.count(), 10.0);
  EXPECT_EQ(star.spokes().size(), 3u);
  EXPECT_EQ(starTriangles(star).size(), 3u);
}

} // namespace

} // namespace local_star_test
