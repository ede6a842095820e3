// SPDX-License-Identifier: BSD-3-Clause
// Predicted size of a path: against the spiral made afterwards, and refused if it is too large.
#include "support/plane_lines.h"

#include "common/available_memory.h"
#include <pcl_spiral/spiral/impl/spiral_curve.h>

#include <gtest/gtest.h>

namespace path_size_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

constexpr double radius = 60.0, area = M_PI * radius * radius;

SpiralSettings
settings(double scallop_height, double chord_error, double max_step)
{
  SpiralSettings s;
  s.tool_radius = 5.0;
  s.scallop_height = scallop_height;
  s.chord_error = chord_error;
  s.max_step = max_step;
  return s;
}

TEST(PathSize, ForetellsTheSpiralsPoints)
{
  const auto lines = test::straightLines([](std::size_t) { return Vector3d(0, 0, 0); }, test::ring(radius, 128));
  // Moves by the chord error on the circles, by the longest step, and turns much closer than both.
  for (const SpiralSettings& s :
       {settings(0.1, 0.002, 0.0), settings(0.1, 1e-5, 0.0), settings(0.1, 0.05, 0.2), settings(1e-5, 0.01, 0.0)}) {
    TurnFunction turns(lines, s, 0.5);
    ASSERT_TRUE(turns.compute().ok());
    const PathSize size = turns.pathSize();
    SpiralCurve curve(lines, turns, s, 0.5);
    curve.setRim(test::ring(radius, 1024), {});
    const auto made = static_cast<double>(curve.sample().size());
    EXPECT_NEAR(size.points, made, 0.15 * made);
    EXPECT_EQ(size.turns, static_cast<double>(turns.turns()));
    EXPECT_EQ(size.knots, 128.0 * size.turns);
    EXPECT_NEAR(size.step * size.points, size.turns * M_PI * radius, 0.05 * size.turns * M_PI * radius) << "the path's length";
    const double rough = roughPathSize(area, s).points; // moves may be as long as the settings allow
    EXPECT_LT(rough, 1.1 * made);
  }
  const SpiralSettings by_step = settings(0.1, 0.05, 0.2);
  TurnFunction turns(lines, by_step, 0.5);
  ASSERT_TRUE(turns.compute().ok());
  EXPECT_NEAR(roughPathSize(area, by_step).points, turns.pathSize().points, 0.1 * turns.pathSize().points);
}

TEST(PathSize, RefusesWhatCannotBeMade)
{
  const SpiralSettings s = settings(0.1, 0.002, 0.0);
  PathSize size = roughPathSize(area, s);
  EXPECT_TRUE(checkPathSize(size, area, s).ok());
  const Status few = checkPathSize(size, area, s, 0.5 * size.points);
  EXPECT_EQ(few.code(), StatusCode::InvalidArgument);
  size.points = std::nan("");
  EXPECT_FALSE(checkPathSize(size, area, s).ok());
  size.points = 10.0;
  size.knots = 2.0 * most_path_points;
  EXPECT_FALSE(checkPathSize(size, area, s).ok());
  const auto memory = availableMemory();
  ASSERT_TRUE(memory.has_value());
  EXPECT_GT(*memory, 1e6);
  size.knots = 0.0;
  size.points = 2.0 * *memory / 200.0;
  const Status large = checkPathSize(size, area, s, 1e300);
  EXPECT_NE(large.message().find("GB are free"), std::string::npos) << large.message();
}

} // namespace

} // namespace path_size_test
