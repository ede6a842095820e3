// SPDX-License-Identifier: BSD-3-Clause
// The judge of finished paths, on paths with figures known by formula.
#include "support/path_judge.h"
#include "support/passes.h"
#include "support/path_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace path_judge_test {

using namespace pcl_spiral::test;
using pcl_spiral::Polyline;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double R = 5.0, h = 0.1;
const double pitch = exactStepOver(R, h, 0.0);

JudgeSettings
settings(std::size_t samples = 20000)
{
  JudgeSettings s;
  s.tool_radius = R;
  s.scallop_height = h;
  s.samples = samples;
  s.spacing = 1.0;
  return s;
}

/** Height in h over a place \p x beside a straight pass on the plane. */
double
heightAt(double x)
{
  return (R - std::sqrt(R * R - x * x)) / h;
}

/** Passes a pitch apart over a square of side 20 pitches, contacts a pitch apart. */
CheckedPath
squarePasses(const AnalyticSurface& square, int missing = -1)
{
  std::vector<double> us;
  for (int i = 0; i <= 20; ++i)
    if (i != missing)
      us.push_back((i - 10) * pitch);
  return straightPasses(square, us, 10.0 * pitch, pitch);
}

SurfacePtr
square()
{
  return flat(Region({rectangle(20.0 * pitch, 20.0 * pitch)}));
}

/** Straight, a half circle to the left, straight back. */
Points
uTurn(double radius)
{
  Points p;
  for (int i = 0; i <= 100; ++i)
    p.push_back({-10.0 + 0.1 * i, 0.0, 0.0});
  for (int i = 1; i < 720; ++i) {
    const double t = pi * i / 720.0;
    p.push_back({radius * std::sin(t), radius * (1.0 - std::cos(t)), 0.0});
  }
  for (int i = 0; i <= 100; ++i)
    p.push_back({-0.1 * i, 2.0 * radius, 0.0});
  return p;
}

} // namespace

TEST(PathJudge, ParallelPassesLeaveTheHeightAskedFor)
{
  const SurfacePtr part = square();
  const JudgedReport f = judgedPath(*part, part->outlines(), squarePasses(*part), settings());
  EXPECT_NEAR(f.inside.p99.value, heightAt(0.99 * 0.5 * pitch), 0.003);
  EXPECT_NEAR(f.inside.p999.value, heightAt(0.999 * 0.5 * pitch), 0.001);
  EXPECT_LE(f.inside.max.value, 1.0 + 1e-9);
  EXPECT_GT(f.inside.max.value, 0.999);
  EXPECT_EQ(f.inside.over_share, 0.0);
  EXPECT_EQ(f.inside.uncut_share, 0.0);
  EXPECT_LT(f.inside.gouge.value, 1e-9);
  EXPECT_NEAR(f.turns, 10.0, 0.1);
  EXPECT_NEAR(static_cast<double>(f.inside.samples) / static_cast<double>(f.whole.samples), 19.8 * 19.8 / 400.0, 0.003);
  EXPECT_EQ(f.rims_missed, 0u);
}

TEST(PathJudge, AMissingPassIsFoundWhereItIs)
{
  const SurfacePtr part = square();
  const JudgedReport f = judgedPath(*part, part->outlines(), squarePasses(*part, 13), settings());
  EXPECT_NEAR(f.inside.max.value, heightAt(pitch), 0.01);
  EXPECT_NEAR(f.inside.max.at.x(), 3.0 * pitch, 0.02 * pitch);
  // Above 1.05 h: from x on to both sides of the missing pass, over a strip as long as the square.
  const double x = std::sqrt(R * R - (R - 1.05 * h) * (R - 1.05 * h));
  EXPECT_NEAR(f.inside.over_share, 2.0 * (pitch - x) / (19.8 * pitch), 0.003);
  EXPECT_EQ(f.inside.uncut_share, 0.0);
}

TEST(PathJudge, WhatIsNotReachedIsUncut)
{
  const SurfacePtr part = square();
  std::vector<double> us;
  for (int i = 0; i <= 12; ++i)
    us.push_back((i - 10) * pitch);
  const CheckedPath path = straightPasses(*part, us, 10.0 * pitch, pitch);
  const JudgedReport f = judgedPath(*part, part->outlines(), path, settings());
  const double reach = std::sqrt(R * R - (R - 20.0 * h) * (R - 20.0 * h)); // higher than 20 h beyond it
  EXPECT_NEAR(f.whole.uncut_share, (8.0 * pitch - reach) / (20.0 * pitch), 0.01);
  EXPECT_GT(f.inside.uncut.at.x(), 2.0 * pitch + reach - 0.1);
  EXPECT_DOUBLE_EQ(f.inside.max.value, 20.0);
}

TEST(PathJudge, AJumpCutsNothing)
{
  const SurfacePtr part = square();
  CheckedPath path = squarePasses(*part);
  const auto inside = [](const Eigen::Vector3d& x) { return std::abs(x.y()) < 3.5 * pitch; };
  CheckedPath lifted;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (!inside(path.contacts[i])) {
      lifted.contacts.push_back(path.contacts[i]);
      lifted.normals.push_back(path.normals[i]);
    }
  const JudgedReport f = judgedPath(*part, part->outlines(), lifted, settings());
  EXPECT_EQ(f.jumps.size(), 21u);
  EXPECT_EQ(f.passes(), 22u);
  const double reach = std::sqrt(R * R - (R - 20.0 * h) * (R - 20.0 * h)); // from 4 pitches in, less between passes
  EXPECT_GT(f.whole.uncut_share, (8.0 * pitch - 2.0 * reach) / (20.0 * pitch) - 0.003);
  EXPECT_LT(f.whole.uncut_share, (8.0 * pitch - 1.8 * reach) / (20.0 * pitch));
}

TEST(PathJudge, CirclesOnADiscAreTheLeastLengthButForTheirJoins)
{
  constexpr int n = 20; // circles of radii k s, k = 0 .. n: pi s n (n + 1) in total, the bound
  const SurfacePtr disc = flat(Region({circle({0.0, 0.0}, n * pitch)}));
  std::vector<double> radii;
  for (int k = n; k > 0; --k)
    radii.push_back(k * pitch);
  radii.push_back(1e-3);
  const CheckedPath path = circularPasses(*disc, radii, [](double r) { return 100 + static_cast<int>(60.0 * r); });
  const JudgedReport f = judgedPath(*disc, disc->outlines(), path, settings());
  EXPECT_NEAR(f.least, pi * pitch * n * (n + 1), 1e-3 * f.least);
  EXPECT_NEAR(f.lengthRatio(), 1.0 + 1.0 / (pi * (n + 1)), 1e-3);
  EXPECT_NEAR(f.trueRatio(), f.lengthRatio(), 1e-9);
  EXPECT_LE(f.inside.max.value, 1.001);
  EXPECT_TRUE(f.crossings.empty());
  EXPECT_EQ(f.passes(), 1u);
  EXPECT_EQ(f.outside_share, 0.0);
}

TEST(PathJudge, APathBeyondTheOutlineIsReported)
{
  const SurfacePtr half = flat(Region({rectangle(10.0 * pitch, 20.0 * pitch)}));
  const SurfacePtr part = square();
  const JudgedReport f = judgedPath(*half, half->outlines(), squarePasses(*part), settings());
  EXPECT_NEAR(f.outside_share, 10.0 / 21.0, 0.03); // the passes over 5.5 pitches from the middle
  EXPECT_NEAR(f.outside.value, 5.0 * pitch, 1e-6);
}

TEST(PathJudge, LoopsInsideTheOutlineAreTheRimsThatCount)
{
  const SurfacePtr disc = flat(Region({circle({0.0, 0.0}, 40.0), circle({5.0, 0.0}, 10.0)}));
  const auto ring = [](double x, double r) {
    Polyline line;
    for (const Eigen::Vector2d& u : circle({x, 0.0}, r, 720))
      line.push_back({u.x(), u.y(), 0.0});
    return line;
  };
  std::size_t missed = 9;
  const std::vector<Polyline> rims = rimsAlong(disc->outlines(), {ring(20.0, 2.0), ring(5.0, 10.5), ring(0.0, 39.5)}, 2.0, missed);
  ASSERT_EQ(rims.size(), 2u);
  EXPECT_EQ(missed, 0u);
  const JudgedArea area(*disc, rims);
  EXPECT_NEAR(area.rimLength(), 2.0 * pi * 50.0, 0.01);
  EXPECT_NEAR(area.leastLength(R, h), pi * (39.5 * 39.5 - 10.5 * 10.5) / pitch + pi * 50.0, 1.0);
  EXPECT_FALSE(area.contains({-39.8, 0.0, 0.0}));
  EXPECT_FALSE(area.contains({15.2, 0.0, 0.0}));
  EXPECT_NEAR(area.rimDistance({-35.0, 0.0, 0.0}), 4.5, 1e-3);
  EXPECT_EQ(rimsAlong(disc->outlines(), {ring(0.0, 39.5)}, 2.0, missed)[1], disc->outlines()[1]);
  EXPECT_EQ(missed, 1u);
}

TEST(PathJudge, TheLeastLengthTakesTheWidestStepThatTheCurvaturesAllow)
{
  const Region region({rectangle(30.0, 40.0)});
  const SurfacePtr round = cylinder(50.0, region), hollow = quadric(80.0, 80.0, Region({circle({0.0, 0.0}, 3.0)}));
  const double arc = 2.0 * 50.0 * std::asin(15.0 / 50.0); // across the axis; the widest step is along it
  EXPECT_NEAR(JudgedArea(*round, round->outlines()).leastLength(R, h), arc * 40.0 / pitch + arc + 40.0, 0.05);
  const double bottom = pi * 9.0 / exactStepOver(R, h, -1.0 / 80.0);
  EXPECT_NEAR(JudgedArea(*hollow, hollow->outlines()).leastLength(R, h), bottom + 3.0 * pi, 0.02);
}

TEST(PathJudge, AGapIsMachinedOrGoneRound)
{
  const SurfacePtr part = square();
  JudgeSettings s = settings();
  s.gap = circle({0.0, 0.0}, 7.0);
  const JudgedReport over = judgedPath(*part, part->outlines(), squarePasses(*part), s);
  EXPECT_TRUE(over.over_gap);
  EXPECT_NEAR(over.least, 400.0 * pitch + 40.0 * pitch, 1.0);
  EXPECT_NEAR(over.lengthRatio(), over.trueRatio(), 1e-9);

  const SurfacePtr disc = flat(Region({circle({0.0, 0.0}, 20.0 * pitch)}));
  s.gap = circle({0.0, 0.0}, 10.0 * pitch);
  std::vector<double> radii;
  for (int k = 20; k >= 10; --k)
    radii.push_back(k * pitch);
  const CheckedPath rings = circularPasses(*disc, radii, [](double r) { return 100 + static_cast<int>(60.0 * r); });
  const JudgedReport round = judgedPath(*disc, disc->outlines(), rings, s);
  EXPECT_FALSE(round.over_gap);
  EXPECT_EQ(round.rims_missed, 1u); // no loop is given for it
  EXPECT_NEAR(round.least, 330.0 * pi * pitch, 0.5);
  EXPECT_NEAR(round.lengthRatio(), 1.0 + 10.0 / (330.0 * pi), 1e-3);
  EXPECT_LE(round.inside.max.value, 1.001);
}

TEST(PathMotion, TurningRadiiAreThoseOfTheCircles)
{
  for (const double r : {0.25, 0.5, 2.0}) {
    const TurningReport f = turningRadii(uTurn(r * pitch), pitch);
    EXPECT_NEAR(f.least.value, r, 0.01 * r);
    EXPECT_GE(f.smallest.value, f.least.value);
    EXPECT_GT(f.least.at.x(), 0.0);
  }
  EXPECT_TRUE(std::isinf(turningRadii({{0, 0, 0}, {50, 0, 0}}, pitch).least.value));
  const Points corner{{0, 0, 0}, {50, 0, 0}, {50, 50, 0}}; // chords of 0.12 pitch at a right angle
  EXPECT_NEAR(turningRadii(corner, pitch).least.value, 0.12 / std::sqrt(2.0), 0.02);
  EXPECT_EQ(turningRadii({{0, 0, 0}, {50, 0, 0}, {0, 0, 0}}, pitch).least.value, 0.0);
}

TEST(PathMotion, ReversalsAreUTurnsWithinTwoPitches)
{
  const ReversalReport sharp = reversals(uTurn(0.5 * pitch), pitch);
  EXPECT_EQ(sharp.count, 1u);
  EXPECT_GT(sharp.share, 0.0);
  EXPECT_EQ(reversals(uTurn(2.0 * pitch), pitch).count, 0u);
  const SurfacePtr part = square();
  EXPECT_EQ(reversals(squarePasses(*part).contacts, pitch).count, 20u);
}

TEST(PathMotion, TimeIsThatOfTheLawsOfMotion)
{
  const double v = 100.0, a = 2000.0, window = 0.3;
  EXPECT_NEAR(machineTime({{0, 0, 0}, {300, 0, 0}}, v, a, window), 300.0 / v + v / a, 1e-6);
  EXPECT_NEAR(machineTime({{0, 0, 0}, {2, 0, 0}}, v, a, window), 2.0 * std::sqrt(2.0 / a),
              1e-6); // never at v
  Points circle;
  for (int i = 0; i <= 3600; ++i)
    circle.push_back({std::cos(2.0 * pi * i / 3600), std::sin(2.0 * pi * i / 3600), 0.0});
  const double slow = std::sqrt(a); // a radius of 1 mm
  EXPECT_NEAR(machineTime(circle, v, a, window), 2.0 * pi / slow + slow / a, 1e-3);
  const double back = machineTime({{0, 0, 0}, {100, 0, 0}, {0, 0, 0}}, v, a, window); // a stop between
  EXPECT_NEAR(back, 2.0 * (100.0 / v + v / a), 0.05);
}

TEST(PathFaults, OneCrossingIsFoundWhereItIs)
{
  const SurfacePtr part = ground({6.0, 45.0, 50.0, 0.0, 0.0}, Region({rectangle(200.0, 200.0)}));
  PassBuilder builder(*part);
  for (int i = 0; i <= 700; ++i) { // a loop that crosses its own start
    const double t = -0.25 * pi + 1.5 * pi * i / 700.0;
    builder.add({60.0 * std::sin(t), 40.0 * std::sin(2.0 * t)}, 0.0);
  }
  const std::vector<Place> found = strictCrossings(*part, builder.path());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].at.head<2>().norm(), 1.0);
  EXPECT_GT(found[0].value, 0.0);
  EXPECT_TRUE(strictCrossings(*part, squarePasses(*part)).empty());
}

TEST(PathFaults, JumpsAreMovesTooLong)
{
  CheckedPath path;
  path.contacts = {{0, 0, 0}, {1, 0, 0}, {9, 0, 0}, {10, 0, 0}};
  const std::vector<Place> found = jumps(path, 5.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].index, 1u);
  EXPECT_DOUBLE_EQ(found[0].value, 8.0);
}

} // namespace path_judge_test
