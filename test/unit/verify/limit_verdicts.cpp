// SPDX-License-Identifier: BSD-3-Clause
// Limits on a judged path: kept, broken with value and place, or too small for the reference to show. The judgements are made up, so
// that every figure and the noise are known.
#include "verify/limit_verdicts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limit_verdicts_test {

using namespace pcl_spiral;

namespace {

using Messages = std::vector<std::string>;

constexpr double noise = 0.002; // of the reference surface: 0.006 can be shown

/** A path without any fault, with a largest deviation of 0.01, a highest scallop of 0.1, a gouge of 0.02, and 1 % uncut. */
Verification
judged()
{
  Verification v;
  v.deviation.points = 500;
  v.deviation.fit_noise = noise;
  v.deviation.max = {-0.01, {1.0, 2.0, 3.0}, 4};
  v.removal.scallop.samples = v.removal.stock.samples = 150;
  v.removal.scallop.max = {0.1, {5.0, 6.0, 7.0}, 8};
  v.removal.stock.uncut = 2;
  v.removal.stock.first_uncut = {2.0, {9.0, 8.0, 7.0}, 6};
  v.removal.rim.samples = 50;
  v.removal.gouge = {0.02, {-1.0, -2.0, -3.5}, 12};
  return v;
}

Limits
allOf(double gouge, double scallop, double deviation, double uncut)
{
  return {gouge, scallop, deviation, uncut};
}

Verdict
verdict(const Limits& limits, Verification v)
{
  v.broken = brokenLimits(limits, v);
  v.unproven = unprovenLimits(limits, v);
  return verdictOf(limits, v);
}

TEST(LimitVerdicts, AValueAtItsLimitIsKept)
{
  const Limits limits = allOf(0.02, 0.1, 0.01, 1.0);
  EXPECT_TRUE(brokenLimits(limits, judged()).empty());
  EXPECT_TRUE(unprovenLimits(limits, judged()).empty());
  EXPECT_EQ(verdict(limits, judged()), Verdict::Kept);
}

TEST(LimitVerdicts, ABrokenLimitIsNamedWithValueAndPlace)
{
  EXPECT_EQ(textsOf(brokenLimits(allOf(0.01, 0.05, 0.009, 0.5), judged())),
            (Messages{"Limits::deviation 0.009 is broken: 0.01 mm at (1, 2, 3), path point 4",
                      "Limits::scallop 0.05 is broken: 0.1 mm at (5, 6, 7), path point 8",
                      "Limits::gouge 0.01 is broken: 0.02 mm at (-1, -2, -3.5), path point 12",
                      "Limits::uncut 0.5 is broken: 1 percent, first at (9, 8, 7), path point 6"}));
  EXPECT_EQ(verdict(allOf(0.01, 1.0, 1.0, 1.0), judged()), Verdict::Broken);
}

TEST(LimitVerdicts, EachLimitIsBrokenAlone)
{
  for (int which = 0; which < 4; ++which) {
    Limits limits;
    (which == 0 ? limits.gouge : which == 1 ? limits.scallop : which == 2 ? limits.deviation : limits.uncut) = 0.0;
    EXPECT_EQ(brokenLimits(limits, judged()).size(), 1U) << which;
  }
}

TEST(LimitVerdicts, TheRimAndWhatLiesBeyondItCount)
{
  Verification v = judged();
  v.deviation.beyond_rim = 3;
  v.deviation.rim_max = {0.03, {1.5, 0.0, 0.0}, 20};
  v.removal.rim.max = {0.3, {2.5, 0.0, 0.0}, 21};
  v.removal.rim_gouge = {0.04, {3.5, 0.0, 0.0}, 22};
  EXPECT_EQ(textsOf(brokenLimits(allOf(0.03, 0.2, 0.02, 1.0), v)),
            (Messages{"Limits::deviation 0.02 is broken: 0.03 mm beyond the rim at (1.5, 0, 0), path point 20",
                      "Limits::scallop 0.2 is broken: 0.3 mm left at the rim at (2.5, 0, 0), path point 21",
                      "Limits::gouge 0.03 is broken: 0.04 mm beyond the rim at (3.5, 0, 0), path point 22"}));
}

TEST(LimitVerdicts, WithoutRidgesTheStockCounts)
{
  Verification v = judged();
  v.removal.scallop = {};
  v.removal.stock.max = {0.4, {0.0, 0.0, 0.0}, 1};
  EXPECT_EQ(brokenLimits(allOf(1.0, 0.3, 1.0, 1.0), v).size(), 1U);
  EXPECT_TRUE(brokenLimits(allOf(1.0, 0.4, 1.0, 1.0), v).empty());
}

TEST(LimitVerdicts, StockBelowTheSurfaceIsNoScallop)
{
  Verification v = judged();
  v.removal.scallop.max.value = -6.0;
  EXPECT_TRUE(brokenLimits(allOf(1.0, 0.05, 1.0, 1.0), v).empty());
}

TEST(LimitVerdicts, AnUnknownValueKeepsNoLimit)
{
  Verification v = judged();
  v.deviation.max.value = std::nan("");
  EXPECT_EQ(brokenLimits(allOf(1.0, 1.0, 1.0, 1.0), v).size(), 1U);
}

TEST(LimitVerdicts, ALimitBelowThreeStandardDeviationsIsNotProven)
{
  Verification v = judged();
  v.deviation.max.value = -0.004;
  EXPECT_DOUBLE_EQ(leastShown(v.deviation), 0.006);
  EXPECT_TRUE(unprovenLimits(allOf(1.0, 1.0, 0.006, 1.0), v).empty()) << "three standard deviations can be shown";
  const Limits limits = allOf(1.0, 1.0, 0.005, 1.0);
  EXPECT_EQ(textsOf(unprovenLimits(limits, v)),
            (Messages{"Limits::deviation 0.005 mm lies below 0.006 mm, three times the noise of the scan's "
                      "surface: this scan cannot show that it holds"}));
  EXPECT_TRUE(brokenLimits(limits, v).empty());
  EXPECT_EQ(verdict(limits, v), Verdict::Unproven);
  v.deviation.by_mesh = true;
  EXPECT_NE(unprovenLimits(limits, v).at(0).text().find("sample more closely (setSampleSpacing)"), std::string::npos);
}

TEST(LimitVerdicts, ABrokenLimitIsNotCalledUnproven)
{
  const Limits limits = allOf(1.0, 1.0, 0.005, 1.0); // the deviation is 0.01
  EXPECT_EQ(brokenLimits(limits, judged()).size(), 1U);
  EXPECT_TRUE(unprovenLimits(limits, judged()).empty());
  EXPECT_EQ(verdict(limits, judged()), Verdict::Broken);
}

TEST(LimitVerdicts, ABrokenLimitThatNoPathCouldBeShownToKeepIsSaidToBeThat)
{
  EXPECT_EQ(textsOf(brokenLimits(allOf(0.004, 1.0, 1.0, 1.0), judged())),
            (Messages{"Limits::gouge 0.004 is broken: 0.02 mm at (-1, -2, -3.5), path point 12; the limit lies below 0.006 mm, three "
                      "times the noise of the scan's surface: this scan cannot show that it holds"}));
}

TEST(LimitVerdicts, ASmallLimitOnScallopOrGougeIsNotProvenEither)
{
  Verification v = judged();
  v.removal.scallop.max.value = v.removal.gouge.value = 0.001;
  EXPECT_EQ(unprovenLimits(allOf(0.005, 0.005, 1.0, 1.0), v).size(), 2U);
}

TEST(LimitVerdicts, NoLimitIsShownToHoldInGaps)
{
  Verification v = judged();
  v.deviation.in_gaps = 7;
  EXPECT_EQ(textsOf(unprovenLimits(allOf(1.0, 1.0, 1.0, 1.0), v)),
            (Messages{"7 path points lie in gaps of the scan: no limit is shown to hold there"}));
}

TEST(LimitVerdicts, NoLimitHoldsIfThePathIsWrong)
{
  Verification v = judged();
  v.deviation.unmeasured = 2;
  v.deviation.opposed = 3;
  v.deviation.first_opposed = {170.0, {1.0, 0.0, 0.0}, 31};
  v.deviation.inward_axes = 4;
  v.deviation.first_inward = {100.0, {2.0, 0.0, 0.0}, 32};
  v.tips_off = 5;
  v.tip_error = {0.5, {3.0, 0.0, 0.0}, 33};
  const Limits limits{std::nullopt, std::nullopt, std::nullopt, 100.0};
  EXPECT_EQ(textsOf(brokenLimits(limits, v)),
            (Messages{"no limit can hold: 2 of 500 path points lie off the surface and were not judged",
                      "no limit can hold: 3 of 500 path points have a normal that points into the material, first at (1, 0, 0), "
                      "path point 31",
                      "no limit can hold: 4 of 500 path points have a tool axis that points into the material, first at (2, 0, 0), "
                      "path point 32",
                      "no limit can hold: 5 of 500 path points have a tool tip that is not this cutter's, the farthest at (3, 0, 0), "
                      "path point 33"}));
  v.deviation.in_gaps = 7;
  EXPECT_EQ(verdict({}, v), Verdict::NoLimits) << "nothing was asked for";
}

} // namespace

} // namespace limit_verdicts_test
