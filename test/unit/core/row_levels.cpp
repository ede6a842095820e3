// SPDX-License-Identifier: BSD-3-Clause
// Levels of rows as far apart as the patches between them allow, and no more levels than needed.
#include "support/sampling.h"

#include "core/row_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace row_levels_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Largest distance of neighbours, divided by the distance that the patches between allow; for the ends, by half of it. */
double
largestShare(const std::vector<RowPatch>& patches, const std::vector<double>& levels, double low, double high, double floor)
{
  std::vector<double> stops{low};
  stops.insert(stops.end(), levels.begin(), levels.end());
  stops.push_back(high);
  double largest = 0.0;
  for (std::size_t k = 0; k + 1 < stops.size(); ++k)
    for (const RowPatch& patch : patches)
      if (patch.high > stops[k] + 1e-9 && patch.low < stops[k + 1] - 1e-9)
        largest =
            std::max(largest, (k == 0 || k + 2 == stops.size() ? 2.0 : 1.0) * (stops[k + 1] - stops[k]) / std::max(floor, patch.most));
  return largest;
}

std::vector<RowPatch>
someShape(std::uint64_t seed, double floor)
{
  Random random(seed);
  std::vector<RowPatch> patches;
  for (int i = 0; i < 400; ++i) {
    const double low = random.uniform(-2.0, 40.0);
    patches.push_back({low, low + random.uniform(0.0, i % 40 == 0 ? 10.0 : 0.3), random.uniform(0.5 * floor, 1.5), random.uniform()});
  }
  return patches;
}

} // namespace

TEST(RowLevels, AllowWhatThePatchesDoWithTheFewestRows)
{
  constexpr double floor = 0.2, low = 0.0, high = 38.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<RowPatch> patches = someShape(seed, floor);
    const RowLevels rows = rowLevels(patches, low, high, floor);
    ASSERT_TRUE(std::is_sorted(rows.levels.begin(), rows.levels.end()));
    ASSERT_GE(rows.levels.front(), low);
    ASSERT_LE(rows.levels.back(), high);
    const double share = largestShare(patches, rows.levels, low, high, floor);
    EXPECT_LE(share, 1.0 + 1e-9);
    EXPECT_GT(share, 0.8) << "no more rows than needed";
    // The least possible number: steps as large as the patches allow, in steps of a thousandth.
    std::size_t fewest = 0;
    for (double at = low, ahead = 0.5; at < high; ++fewest, ahead = 1.0) {
      double next = at;
      const auto fits = [&](double to, double part) {
        for (const RowPatch& patch : patches)
          if (patch.high > at && patch.low < to && to - at > part * std::max(floor, patch.most))
            return false;
        return true;
      };
      if (ahead == 1.0 && fits(high, 0.5))
        break;
      while (next < high && fits(next + 1e-3, ahead))
        next += 1e-3;
      at = next;
    }
    EXPECT_LE(static_cast<double>(rows.levels.size()), 1.04 * static_cast<double>(fewest) + 1.0) << seed;
    EXPECT_GE(rows.levels.size() + 1, fewest);
  }
}

TEST(RowLevels, AreEvenWhereAllIsAlike)
{
  for (const double extent : {0.3, 1.0, 2.0, 7.3, 20.0}) {
    const RowLevels rows = rowLevels({{-1.0, 25.0, 2.0, 1.0}}, 0.0, extent, 0.5);
    const std::size_t count = static_cast<std::size_t>(std::ceil(extent / 2.0 - 1e-9));
    ASSERT_EQ(rows.levels.size(), count) << extent;
    for (std::size_t k = 0; k < count; ++k)
      EXPECT_NEAR(rows.levels[k], extent * (static_cast<double>(k) + 0.5) / static_cast<double>(count), 1e-6);
    EXPECT_NEAR(rows.largest_step, count > 1 ? extent / static_cast<double>(count) : 0.0, 1e-6);
    EXPECT_NEAR(rows.smallest_step, rows.largest_step, 1e-6);
  }
}

TEST(RowLevels, AreCloserOnlyWhereNeeded)
{
  const RowLevels rows = rowLevels({{0.0, 50.0, 1.0, 50.0}, {50.0, 100.0, 0.25, 50.0}}, 0.0, 100.0, 0.2);
  EXPECT_NEAR(static_cast<double>(rows.levels.size()), 250.0, 2.0);
  EXPECT_NEAR(rows.largest_step, 1.0, 0.02);
  EXPECT_NEAR(rows.smallest_step, 0.25, 0.01);
  EXPECT_EQ(rows.held_share, 0.0);
}

TEST(RowLevels, AreHeldAtTheFloorAndSayWhere)
{
  const std::vector<RowPatch> patches{{0.0, 6.0, 1.0, 6.0}, {6.0, 6.5, 0.01, 1.0}, {6.5, 7.0, 0.0, 1.0}, {7.0, 10.0, infinity, 2.0}};
  const RowLevels rows = rowLevels(patches, 0.0, 10.0, 0.2);
  EXPECT_EQ(rows.narrowest, 2U);
  EXPECT_NEAR(rows.held_share, 0.2, 1e-12);
  EXPECT_LT(rows.levels.size(), 15U);
  EXPECT_LE(largestShare(patches, rows.levels, 0.0, 10.0, 0.2), 1.0 + 1e-9);
  const double nan = std::nan("");
  EXPECT_EQ(rowLevels({{nan, nan, 1.0, 1.0}, {0.0, 1.0, nan, 1.0}, {0.0, 4.0, 1.0, 1.0}}, 0.0, 4.0, 0.1).levels.size(), 4U);
  EXPECT_EQ(rowLevels({}, 0.0, 4.0, 0.1).levels.size(), 1U);
  EXPECT_EQ(rowLevels(patches, 3.0, 3.0, 0.2).levels, std::vector<double>{3.0});
}

} // namespace row_levels_test
