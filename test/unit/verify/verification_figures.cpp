// SPDX-License-Identifier: BSD-3-Clause
// The one list of figures: each key once, each limit at its figures, places where there are any.
#include "verify/verification_figures.h"

#include <gtest/gtest.h>

#include <set>

namespace verification_figures_test {

using namespace pcl_spiral;

namespace {

std::size_t
limitedFigures(const Limits& limits)
{
  std::size_t count = 0;
  const FigureTable table = figuresOf({}, limits);
  for (const Figure& figure : table.figures())
    count += figure.limit ? 1 : 0;
  return count;
}

TEST(VerificationFigures, EachKeyStandsOnce)
{
  std::set<std::string> keys;
  const FigureTable table = figuresOf({});
  for (const Figure& figure : table.figures())
    EXPECT_TRUE(keys.insert(figure.key).second) << figure.key;
}

TEST(VerificationFigures, LimitsStandAtTheirFigures)
{
  EXPECT_EQ(limitedFigures({}), 0U);
  EXPECT_EQ(limitedFigures({0.1, std::nullopt, std::nullopt, std::nullopt}), 3U) << "gouge, also beyond the rim, and into flat faces";
  EXPECT_EQ(limitedFigures({std::nullopt, 0.1, std::nullopt, std::nullopt}), 2U) << "scallop, and stock at the rim";
  EXPECT_EQ(limitedFigures({std::nullopt, std::nullopt, 0.1, std::nullopt}), 2U) << "deviation, also beyond the rim";
  EXPECT_EQ(limitedFigures({std::nullopt, std::nullopt, std::nullopt, 0.1}), 1U) << "uncut";
  Verification v;
  v.deviation.max.value = -0.2;
  const FigureTable broken = figuresOf(v, {std::nullopt, std::nullopt, 0.1, std::nullopt});
  EXPECT_FALSE(broken.at("deviation/max").limit->holds()) << "its sign does not count";
  EXPECT_TRUE(broken.at("deviation/beyond_rim_max").limit->holds());
}

TEST(VerificationFigures, WhatWasNotMeasuredIsNotKnown)
{
  Verification v;
  EXPECT_FALSE(figuresOf(v).at("deviation/beyond_rim_max").known);
  EXPECT_FALSE(figuresOf(v).at("material/scallop/p99").known);
  EXPECT_FALSE(figuresOf(v).at("material/gouge").known);
  EXPECT_EQ(figuresOf(v).at("material/gouge").if_none, "none");
  v.deviation.beyond_rim = v.removal.scallop.samples = 1;
  v.removal.gouge.value = 0.1;
  EXPECT_TRUE(figuresOf(v).at("deviation/beyond_rim_max").known);
  EXPECT_TRUE(figuresOf(v).at("material/scallop/p99").known);
  EXPECT_TRUE(figuresOf(v).at("material/gouge").known);
}

TEST(VerificationFigures, UncutPointsOfSurfaceAndRimAreCountedTogether)
{
  Verification v;
  v.removal.stock.samples = 30;
  v.removal.rim.samples = 10;
  EXPECT_EQ(figuresOf(v).at("material/uncut").value, 0.0);
  EXPECT_FALSE(figuresOf(v).at("material/uncut").place);
  EXPECT_FALSE(figuresOf(v).at("material/rim_band/first_uncut").place);
  v.removal.rim.uncut = 4;
  v.removal.rim.first_uncut = {2.0, {1.0, 2.0, 3.0}, 5};
  EXPECT_DOUBLE_EQ(figuresOf(v).at("material/uncut").value, 10.0);
  EXPECT_EQ(figuresOf(v).at("material/uncut").place->index, 5U);
  EXPECT_EQ(figuresOf(v).at("material/rim_band/first_uncut").place->index, 5U);
}

} // namespace

} // namespace verification_figures_test
