// SPDX-License-Identifier: BSD-3-Clause
// Pairs of points on two loops: against all possible pairings, and in cases with a known answer.
#include "spiral/loops/loop_matching.h"
#include "support/plane_lines.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace loop_matching_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

/** The least cost over all starts and both senses. */
double
leastOfAll(const Polyline& seeds, const Polyline& candidates)
{
  double least = 1e300;
  std::vector<std::size_t> partners;
  const std::function<void(std::size_t)> extend = [&](std::size_t from) {
    if (partners.size() == seeds.size()) {
      const std::size_t last_way = partners.front() + candidates.size() - partners.back();
      if (last_way <= 4 * candidates.size() / seeds.size())
        least = std::min(least, matchingCost(seeds, candidates, partners));
      return;
    }
    for (std::size_t k = from; k <= std::min(from + 4 * candidates.size() / seeds.size(), partners.front() + candidates.size()); ++k) {
      partners.push_back(k);
      extend(k);
      partners.pop_back();
    }
  };
  for (std::size_t first = 0; first < candidates.size(); ++first) {
    partners.assign(1, first);
    extend(first);
  }
  return least;
}

TEST(LoopMatching, IsTheBestOfAll)
{
  test::Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    Polyline seeds = test::ring(10.0, 4), candidates = test::ring(4.0, 8);
    for (Polyline* loop : {&seeds, &candidates})
      for (Vector3d& p : *loop)
        p += 3.0 * Vector3d(random.normal(), random.normal(), random.normal());
    const auto partners = matchLoops(seeds, candidates);
    ASSERT_EQ(partners.size(), seeds.size());
    EXPECT_TRUE(std::is_sorted(partners.begin(), partners.end()));
    EXPECT_LE(partners.back(), partners.front() + candidates.size());
    EXPECT_NEAR(matchingCost(seeds, candidates, partners), leastOfAll(seeds, candidates), 1e-9);
  }
}

TEST(LoopMatching, ConcentricRingsPairAlongRadii)
{
  const Polyline seeds = test::ring(100.0, 32);
  Polyline candidates = test::ring(40.0, 128);
  std::rotate(candidates.begin(), candidates.begin() + 37, candidates.end());
  const auto partners = matchLoops(seeds, candidates);
  for (std::size_t i = 0; i < seeds.size(); ++i)
    EXPECT_LT((candidates[partners[i] % 128] - 0.4 * seeds[i]).norm(), 1e-9);
}

TEST(LoopMatching, OffCentreRingsKeepOrder)
{
  const Polyline seeds = test::ring(100.0, 64);
  Polyline candidates = test::ring(30.0, 256);
  for (Vector3d& p : candidates)
    p.x() += 50.0;
  const auto partners = matchLoops(seeds, candidates);
  double longest = 0.0;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const std::size_t next = i + 1 < seeds.size() ? partners[i + 1] : partners[0] + 256;
    longest = std::max(longest, static_cast<double>(next - partners[i]) / 4.0);
  }
  EXPECT_LT((candidates[partners[0] % 256] - Vector3d(80, 0, 0)).norm(),
            1.0);                                                               // nearest to the seed on the axis
  EXPECT_LT((candidates[partners[32] % 256] - Vector3d(20, 0, 0)).norm(), 1.0); // and on the far side of it
  EXPECT_LT(longest, 2.0);
}

} // namespace

} // namespace loop_matching_test
