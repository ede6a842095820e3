// SPDX-License-Identifier: BSD-3-Clause
// Axes of passes: rings against rings with another start and rings with many more rounds; beams by the places of their spots.
#include "drive/pass_axes.h"

#include "core/smooth_axes.h"
#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace pass_axes_test {

using namespace pcl_spiral;

namespace {

using Eigen::Vector3d;

double
angleBetween(const Vector3d& a, const Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** A ring of radius 50 with axes tilted outwards by varying angles, with noise. */
DrivePass
ring(std::size_t points = 200)
{
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.03);
  DrivePass pass;
  pass.closed = true;
  for (std::size_t i = 0; i < points; ++i) {
    const double angle = full_turn * static_cast<double>(i) / static_cast<double>(points);
    const Vector3d out(std::cos(angle), std::sin(angle), 0.0);
    DrivePoint p;
    p.position = 50.0 * out;
    p.normal = (Vector3d::UnitZ() + 0.3 * out).normalized();
    p.axis = Vector3d::UnitZ() + (0.3 + 0.2 * std::cos(3.0 * angle)) * out + Vector3d(noise(random), noise(random), 0.0);
    pass.points.push_back(p);
  }
  return pass;
}

/** The same ring with another start point. */
DrivePass
begunAt(DrivePass pass, std::size_t point)
{
  std::rotate(pass.points.begin(), pass.points.begin() + static_cast<std::ptrdiff_t>(point), pass.points.end());
  return pass;
}

DrivePass
smoothed(const DrivePass& pass, const PassAxisSettings& settings)
{
  DrivePasses passes{pass};
  PassAxisReport report;
  const Status status = smoothPassAxes(settings, passes, report);
  EXPECT_TRUE(status.ok()) << status.message();
  return passes.front();
}

double
largestDifference(const DrivePass& a, const DrivePass& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    largest = std::max(largest, angleBetween(a.points[i].axis, b.points[i].axis));
  return largest;
}

PassAxisSettings
over(double length, double rate = 0.0)
{
  PassAxisSettings settings;
  settings.smoothing_length = length;
  settings.max_rate = rate;
  return settings;
}

/** Axes of a pass that swing by \p angle degrees, a point every mm. */
DrivePass
swinging(double angle)
{
  DrivePass pass;
  for (int i = 0; i < 60; ++i) {
    DrivePoint p;
    p.position = {1.0 * i, 0.0, 0.0};
    p.axis = {i / 20 % 2 == 0 ? 0.0 : std::sin(angle * degree), 0.0, i / 20 % 2 == 0 ? 1.0 : std::cos(angle * degree)};
    pass.points.push_back(p);
  }
  return pass;
}

} // namespace

TEST(PassAxes, ARingHasNoSeam)
{
  DrivePass open = ring();
  open.closed = false;
  for (const std::size_t start : {1U, 77U, 199U}) {
    EXPECT_LT(largestDifference(begunAt(smoothed(ring(), over(8.0)), start), smoothed(begunAt(ring(), start), over(8.0))), 1e-9);
    EXPECT_GT(largestDifference(begunAt(smoothed(open, over(8.0)), start), smoothed(begunAt(open, start), over(8.0))), 0.01)
        << "an open one has";
  }
  EXPECT_GT(largestDifference(ring(), smoothed(ring(), over(8.0))), 0.03);
}

/** The effect of rounds before and after a ring decreases: nine of them are enough. */
TEST(PassAxes, ARingIsThatOfManyRounds)
{
  constexpr int rounds = 9;
  const DrivePass one = ring();
  for (const double length : {3.0, 8.0, 25.0}) {
    Polyline points;
    std::vector<Vector3d> axes;
    for (int round = 0; round < rounds; ++round)
      for (const DrivePoint& p : one.points) {
        points.push_back(p.position);
        axes.push_back(p.axis.normalized());
      }
    const SmoothAxes many = smoothAxes(points, axes, {length, 20.0 * degree, 0.0});
    DrivePass middle = one;
    for (std::size_t i = 0; i < one.points.size(); ++i)
      middle.points[i].axis = many.axes[rounds / 2 * one.points.size() + i];
    EXPECT_LT(largestDifference(smoothed(one, over(length)), middle), length > 10.0 ? 1e-4 : 1e-9) << length;
  }
}

TEST(PassAxes, ARingKeepsTheRateOnItsLastMoveToo)
{
  DrivePass pass = ring();
  for (std::size_t i = 0; i < pass.points.size(); ++i)
    pass.points[i].axis = i < 100 ? Vector3d(0.0, 0.0, 1.0) : Vector3d(0.2, 0.0, 1.0); // a step at the seam and one opposite
  constexpr double rate = 0.5;
  const auto steepest = [](const DrivePass& some) {
    double largest = 0.0;
    for (std::size_t i = 0; i < some.points.size(); ++i) {
      const DrivePoint &p = some.points[i], &next = some.points[(i + 1) % some.points.size()];
      largest = std::max(largest, angleBetween(p.axis, next.axis) / degree / (next.position - p.position).norm());
    }
    return largest;
  };
  EXPECT_GT(steepest(pass), 5.0 * rate);
  EXPECT_LT(steepest(smoothed(pass, over(0.0, rate))), rate * (1.0 + 1e-6));
  pass.closed = false;
  EXPECT_GT(steepest(smoothed(pass, over(0.0, rate))), 5.0 * rate) << "an open one does not join its ends";
}

TEST(PassAxes, AnOpenPassIsSmoothedFromEndToEnd)
{
  DrivePass pass = ring();
  pass.closed = false;
  Polyline points;
  std::vector<Vector3d> axes;
  for (const DrivePoint& p : pass.points) {
    points.push_back(p.position);
    axes.push_back(p.axis.normalized());
  }
  const SmoothAxes plain = smoothAxes(points, axes, {12.0, 20.0 * degree, 2.0 * degree});
  const DrivePass found = smoothed(pass, over(12.0, 2.0));
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(found.points[i].axis, plain.axes[i]);
    EXPECT_EQ(found.points[i].position, points[i]) << "a cutter stays where it is";
  }
}

TEST(PassAxes, TheSpotOfABeamStays)
{
  constexpr double stand_off = 12.0;
  const auto spotOf = [](const DrivePoint& p, double reach) { return Vector3d(p.position - reach * p.axis.normalized()); };
  PassAxisSettings settings = over(8.0);
  settings.stand_off = stand_off;
  const DrivePass before = ring(), after = smoothed(before, settings);
  double moved = 0.0;
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    const DrivePoint& p = before.points[i];
    const double reach = beamReach(p, stand_off);
    EXPECT_NEAR(reach * p.axis.normalized().dot(p.normal), stand_off, 1e-12) << "as high over the surface";
    EXPECT_LT((spotOf(p, reach) - spotOf(after.points[i], reach)).norm(), 1e-12);
    moved = std::max(moved, (p.position - after.points[i].position).norm());
  }
  EXPECT_GT(moved, 0.3);
}

TEST(PassAxes, AxesThatWouldLeanTooFarAreRefusedAndTheRemedyHelps)
{
  const DrivePass pass = swinging(80.0);
  DrivePasses passes{ring(), pass};
  PassAxisReport report;
  const Status status = smoothPassAxes(over(0.0, 0.1), passes, report);
  EXPECT_EQ(status.code(), StatusCode::InvalidArgument);
  for (const char* part : {"at an axis rate of 0.1 degrees per mm", " degrees from the requested axes", "raise the rate"})
    EXPECT_NE(status.message().find(part), std::string::npos) << status.message();
  EXPECT_GT(report.largest_deviation, 45.0);
  for (std::size_t i = 0; i < pass.points.size(); ++i)
    EXPECT_EQ(passes[1].points[i].axis, pass.points[i].axis) << "unchanged";
  EXPECT_EQ(passes[0].points[5].axis, ring().points[5].axis);
  ASSERT_TRUE(smoothPassAxes(over(0.0, 20.0), passes, report).ok());
  EXPECT_LT(report.largest_deviation, 45.0);
  ASSERT_EQ(report.warnings.size(), 1U);
  EXPECT_EQ(report.warnings[0].text().find("smoothing and the rate limit turn axes by up to "), 0U);
}

TEST(PassAxes, WithoutLengthAndRateNothingChanges)
{
  PassAxisSettings settings;
  settings.stand_off = 10.0;
  const DrivePass before = ring(), after = smoothed(before, settings);
  for (std::size_t i = 0; i < before.points.size(); ++i) {
    EXPECT_EQ(before.points[i].axis, after.points[i].axis);
    EXPECT_EQ(before.points[i].position, after.points[i].position);
  }
}

TEST(PassAxes, SettingsOutOfRangeAreRefused)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wrong : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
    DrivePasses passes{ring()};
    PassAxisReport report;
    EXPECT_NE(smoothPassAxes(over(wrong), passes, report).message().find("(PassSettings::axis_smoothing)"), std::string::npos);
    EXPECT_NE(smoothPassAxes(over(8.0, wrong), passes, report).message().find("(PassSettings::max_axis_rate)"), std::string::npos);
  }
  for (double PassAxisSettings::*deviation : {&PassAxisSettings::max_deviation, &PassAxisSettings::largest_deviation})
    for (const double wrong : {0.0, -1.0, nan}) {
      PassAxisSettings settings = over(8.0);
      settings.*deviation = wrong;
      DrivePasses passes{ring()};
      PassAxisReport report;
      EXPECT_EQ(smoothPassAxes(settings, passes, report).code(), StatusCode::InvalidArgument);
    }
}

} // namespace pass_axes_test
