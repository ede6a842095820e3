// SPDX-License-Identifier: BSD-3-Clause
// Layout of a picture: axes apart from each other and from the part, turns apart on the screen.
#include "visualization/box_axes.h"
#include "visualization/shown_turns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace picture_layout_test {

using namespace pcl_spiral;

namespace {

/** View from \p azimuth about z and \p tilt off z, degrees; the whole box is about 800 pixels large. */
ParallelView
viewFrom(double azimuth, double tilt, const Eigen::Vector3d& size)
{
  const double a = azimuth * M_PI / 180.0, t = tilt * M_PI / 180.0;
  const Eigen::Vector3d right(std::cos(a), std::sin(a), 0.0);
  const Eigen::Vector3d towards(std::sin(t) * std::sin(a), -std::sin(t) * std::cos(a), std::cos(t));
  return {right, towards.cross(right), size.norm() / 900.0};
}

bool
overlap(const AxisText& a, const AxisText& b)
{
  const Eigen::Array2d apart = (a.middle - b.middle).cwiseAbs(), room = a.half_size + b.half_size;
  return apart.x() < room.x() && apart.y() < room.y();
}

/** Length of \p a that runs within 10 pixels of \p b, except where they meet in a corner. */
double
lengthAlong(const BoxAxis& a, const BoxAxis& b)
{
  constexpr int steps = 400;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      if (((a.from + (a.to - a.from) * i / steps) - (b.from + (b.to - b.from) * j / steps)).norm() < 10.0) {
        sum += (a.to - a.from).norm() / steps;
        break;
      }
  return sum;
}

void
expectLegible(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const ParallelView& view)
{
  const std::vector<BoxAxis> axes = layOutAxes(low, high, view);
  std::size_t expected = 0;
  for (int k = 0; k < 3; ++k)
    expected += view.project((high[k] - low[k]) * Eigen::Vector3d::Unit(k)).norm() >= 40.0;
  EXPECT_EQ(axes.size(), expected);
  std::vector<AxisText> texts;
  for (const BoxAxis& axis : axes) {
    const double length = (axis.to - axis.from).norm();
    EXPECT_NEAR(length, view.project((high[axis.axis] - low[axis.axis]) * Eigen::Vector3d::Unit(axis.axis)).norm(), 1e-6);
    ASSERT_FALSE(axis.texts.empty());
    EXPECT_EQ(axis.texts.front().words, std::string(1, "xyz"[axis.axis]) + ", mm");
    for (std::size_t i = 1; i < axis.texts.size(); ++i) {
      // every number is beside its place
      const double share = (std::atof(axis.texts[i].words.c_str()) - low[axis.axis]) / (high[axis.axis] - low[axis.axis]);
      const Eigen::Vector2d named = axis.from + share * (axis.to - axis.from);
      const Eigen::Vector2d off = axis.texts[i].middle - named;
      EXPECT_NEAR(off.dot(axis.to - axis.from) / length, 0.0, 0.01 * length);
    }
    for (const AxisText& text : axis.texts) {
      // clear of the box: all its corners are on the other side of the axis
      EXPECT_GT(axis.outward.dot(text.middle - axis.from), axis.outward.cwiseAbs().dot(text.half_size));
      for (const AxisText& other : texts)
        EXPECT_FALSE(overlap(text, other)) << text.words << " over " << other.words;
      texts.push_back(text);
    }
    for (int c = 0; c < 8; ++c) {
      const Eigen::Vector3d corner((c & 1 ? high : low).x(), (c & 2 ? high : low).y(), (c & 4 ? high : low).z());
      EXPECT_LT(axis.outward.dot(view.project(corner) - axis.from), 3.5);
    }
    for (const BoxAxis& other : axes)
      if (other.axis != axis.axis)
        EXPECT_LT(lengthAlong(axis, other), 80.0) << "xyz"[axis.axis] << " runs along "
                                                  << "xyz"[other.axis];
  }
}

/** A flat spiral of this pitch, mm, about the origin. */
pcl::PointCloud<ToolpathPoint>
flatSpiral(double pitch, int turns)
{
  pcl::PointCloud<ToolpathPoint> path;
  for (int i = 0; i <= 120 * turns; ++i) {
    const double turn = i / 120.0;
    ToolpathPoint point;
    point.x = static_cast<float>(pitch * turn * std::cos(2.0 * M_PI * turn));
    point.y = static_cast<float>(pitch * turn * std::sin(2.0 * M_PI * turn));
    point.normal_z = 1.0f;
    point.turn = static_cast<float>(turn);
    path.push_back(point);
  }
  return path;
}

} // namespace

TEST(BoxAxes, AreApartInTheUsualViewOfFlatAndTallParts)
{
  for (const double height : {2.0, 40.0, 130.0, 200.0, 600.0}) {
    const Eigen::Vector3d low(-55.0, -65.0, 1.0), high(75.0, 70.0, 1.0 + height);
    for (const double tilt : {35.0, 34.0, 36.0})
      for (const double azimuth : {0.0, 0.1, -0.3, 90.0, 180.0}) {
        SCOPED_TRACE(std::to_string(height) + " mm high, tilt " + std::to_string(tilt) + ", azimuth " + std::to_string(azimuth));
        expectLegible(low, high, viewFrom(azimuth, tilt, high - low));
      }
  }
}

TEST(BoxAxes, AreApartFromAnySide)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector3d low = 1000.0 * (Eigen::Vector3d::NullaryExpr([&] { return unit(random) - 0.5; }));
    const Eigen::Vector3d size = Eigen::Vector3d::NullaryExpr([&] { return std::pow(10.0, 1.0 + 2.0 * unit(random)); });
    SCOPED_TRACE(trial);
    expectLegible(low, low + size, viewFrom(360.0 * unit(random), 180.0 * unit(random), size));
  }
}

TEST(ShownTurns, StandFourPixelsApart)
{
  const ParallelView above = viewFrom(0.0, 0.0, {900.0, 0.0, 0.0}); // a pixel is a millimetre
  EXPECT_EQ(chooseTurns(flatSpiral(4.5, 80), above, 4.0).every, 1);
  EXPECT_EQ(chooseTurns(flatSpiral(2.1, 150), above, 4.0).every, 2);
  EXPECT_EQ(chooseTurns(flatSpiral(0.3, 1000), above, 4.0).every, 14);
  // tilted by 60 degrees, turns are half as far apart where they run across the view
  const int tilted = chooseTurns(flatSpiral(0.3, 1000), viewFrom(0.0, 60.0, {900.0, 0.0, 0.0}), 4.0).every;
  EXPECT_GE(tilted, 24);
  EXPECT_LE(tilted, 27);
  EXPECT_EQ(chooseTurns(flatSpiral(1e-4, 60), above, 4.0).every, 10) << "six turns stay, however dense";
}

TEST(ShownTurns, FirstAndLastAreAmongThem)
{
  const ShownTurns turns{8, 45};
  std::vector<int> shown;
  for (int k = 0; k < turns.turns; ++k)
    if (turns.shows(k + 0.5))
      shown.push_back(k);
  EXPECT_EQ(shown, (std::vector<int>{0, 12, 20, 28, 36, 44}));
  EXPECT_TRUE(turns.shows(45.0)) << "the very end";
}

TEST(ShownTurns, CaptionSaysWhich)
{
  const auto caption = [](int every) { return ShownTurns{every, 1000}.caption(); };
  EXPECT_EQ(caption(1), "every turn shown");
  EXPECT_EQ(caption(2), "every 2nd turn shown");
  EXPECT_EQ(caption(3), "every 3rd turn shown");
  EXPECT_EQ(caption(8), "every 8th turn shown");
  EXPECT_EQ(caption(11), "every 11th turn shown");
  EXPECT_EQ(caption(12), "every 12th turn shown");
  EXPECT_EQ(caption(21), "every 21st turn shown");
  EXPECT_EQ(caption(113), "every 113th turn shown");
}

} // namespace picture_layout_test
