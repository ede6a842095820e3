// SPDX-License-Identifier: BSD-3-Clause
// Wobble from turn to turn of flat spirals with deviations of known second difference across the turns.
#include <pcl_spiral/verify/impl/turn_wobble.h>

#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace turn_wobble_test {

using namespace pcl_spiral;

namespace {

constexpr int turn_count = 20, points_a_turn = 64;

/** An Archimedean spiral; its points are at the same angles of every turn. */
CutterPath
spiral()
{
  CutterPath path;
  for (int i = 0; i <= turn_count * points_a_turn; ++i) {
    const double turn = static_cast<double>(i) / points_a_turn, angle = 2.0 * M_PI * turn;
    path.contacts.emplace_back(2.0 * turn * std::cos(angle), 2.0 * turn * std::sin(angle), 0.0);
    path.normals.push_back(Eigen::Vector3d::UnitZ());
    path.turns.push_back(static_cast<float>(turn));
  }
  return path;
}

std::vector<float>
deviations(const CutterPath& path, const std::function<double(double)>& of_turn)
{
  std::vector<float> deviation;
  for (const float turn : path.turns)
    deviation.push_back(static_cast<float>(of_turn(turn)));
  return deviation;
}

} // namespace

TEST(TurnWobble, WhatTheTurnsShareOrWhatChangesEvenlyIsNone)
{
  const CutterPath path = spiral();
  for (const auto& even : std::vector<std::function<double(double)>>{[](double) { return 0.3; }, [](double t) { return 0.02 * t - 0.1; },
                                                                     [](double t) { return 0.2 * std::sin(2.0 * M_PI * t); }}) {
    const TurnWobble wobble = turnWobble(path, deviations(path, even));
    EXPECT_EQ(wobble.measured, static_cast<std::size_t>((turn_count - 2) * points_a_turn));
    EXPECT_LT(std::abs(wobble.max.value), 1e-6);
  }
}

TEST(TurnWobble, AlternatingTurnsMakeTwiceTheirAmount)
{
  const CutterPath path = spiral();
  const TurnWobble wobble = turnWobble(path, deviations(path, [](double t) { return 0.1 * std::cos(M_PI * t); }));
  EXPECT_NEAR(wobble.rms, 0.2 / std::sqrt(2.0), 1e-3);
  EXPECT_NEAR(std::abs(wobble.max.value), 0.2, 1e-6);
}

TEST(TurnWobble, IndependentErrorsMakeTheirShare)
{
  const CutterPath path = spiral();
  test::Random random(3);
  const TurnWobble wobble = turnWobble(path, deviations(path, [&](double) { return 0.05 * random.normal(); }));
  EXPECT_NEAR(wobble.rms, 0.05 * std::sqrt(1.5), 0.05 * 0.1);
}

TEST(TurnWobble, OneContactOffIsFoundInItsPlace)
{
  const CutterPath path = spiral();
  std::vector<float> deviation(path.size(), 0.0f);
  deviation[700] = -0.08f;
  const TurnWobble wobble = turnWobble(path, deviation);
  EXPECT_NEAR(wobble.max.value, -0.08, 1e-6);
  EXPECT_EQ(wobble.max.index, 700u);
  EXPECT_EQ(wobble.max.position, path.contacts[700]);
}

TEST(TurnWobble, NothingIsMeasuredWithoutDeviationsOrTurns)
{
  CutterPath path = spiral();
  std::vector<float> deviation(path.size(), 0.0f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  deviation[700] = nan;
  EXPECT_EQ(turnWobble(path, deviation).measured, static_cast<std::size_t>((turn_count - 2) * points_a_turn - 3));
  EXPECT_EQ(turnWobble(path, std::vector<float>(path.size(), nan)).measured, 0u);
  deviation[700] = 0.0f;
  std::swap(path.turns.front(), path.turns.back());
  EXPECT_EQ(turnWobble(path, deviation).measured, 0u);
  path.turns.clear();
  EXPECT_EQ(turnWobble(path, deviation).measured, 0u);
}

TEST(TurnWobble, RowsThatTheTurnCountsHaveNone)
{
  CutterPath path; // the deviation of a row does not depend on the end of the next row
  std::vector<float> deviation;
  for (int row = 0; row < 10; ++row)
    for (int i = 0; i < 20; ++i) {
      path.contacts.emplace_back(i, row, 0.0);
      path.normals.push_back(Eigen::Vector3d::UnitZ());
      path.turns.push_back(static_cast<float>(row));
      deviation.push_back(0.01f * static_cast<float>(i));
      if (row > 0 && i == 0)
        path.passes.push_back(path.contacts.size() - 1);
    }
  EXPECT_EQ(turnWobble(path, deviation).measured, 0u);
}

} // namespace turn_wobble_test
