// SPDX-License-Identifier: BSD-3-Clause
// The earlier method, three long lines and arcs across them, compared with a rail and a generator.
#include <pcl_spiral/ridge/ridge_surface.h>

#include "support/made_ridge.h"
#include "support/ridges.h"
#include "support/three_lines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace ridge_earlier_method_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double noise = 0.02;

/** Distances of places from a surface. */
struct Off {
  double squares = 0.0, largest = 0.0;
  std::size_t places = 0;

  double rms() const { return std::sqrt(squares / static_cast<double>(places)); }
};

void
take(double distance, Off& off)
{
  off.squares += distance * distance;
  off.largest = std::max(off.largest, distance);
  ++off.places;
}

/** Places of a surface, by shares from 0 to 1 of its rail and its generator, against the exact ridge. */
Off
offOf(const ExactRidge& exact, const std::function<Vector3d(double, double)>& surface)
{
  constexpr int along = 60, across = 16;
  Off off;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j)
      take(exact.distance(surface(static_cast<double>(i) / along, static_cast<double>(j) / across)), off);
  return off;
}

/** Start, middle and end of the generator along the whole rail, \p points a line, measured with noise. */
ThreeLines
measuredLines(const ExactRidge& exact, std::size_t points, double sigma, std::uint64_t seed)
{
  ThreeLines three;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < points; ++i)
      three.lines[k].push_back(exact.position(static_cast<double>(i) / static_cast<double>(points - 1), 0.5 * static_cast<double>(k)));
    three.lines[k] = moved(three.lines[k], sigma, seed + k);
  }
  return three;
}

Off
offOf(const ExactRidge& exact, const ThreeLines& three)
{
  return offOf(exact, [&](double t, double w) {
    return three.position(static_cast<std::size_t>(std::lround(t * static_cast<double>(three.stations() - 1))), w);
  });
}

Off
offOf(const ExactRidge& exact, const RidgeSurface& surface)
{
  return offOf(exact, [&](double t, double w) { return surface.position(t * surface.rail().length(), w * surface.generator().length()); });
}

double
lengthOf(const std::vector<Vector3d>& line)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += (line[i] - line[i - 1]).norm();
  return sum;
}

/** At equal steps, from the first on. */
std::size_t
pointsAt(double step, double length)
{
  return static_cast<std::size_t>(std::floor(length / step)) + 1;
}

} // namespace

TEST(EarlierMethod, GoesThroughItsThreeLinesAndFitsArcs)
{
  ExactRidge exact = dieRidge();
  const ThreeLines three = measuredLines(exact, 50, 0.0, 1);
  for (std::size_t station = 0; station < three.stations(); station += 7) {
    EXPECT_LT((three.position(station, 0.0) - three.lines[0][station]).norm(), 1e-9);
    EXPECT_LT((three.position(station, 1.0) - three.lines[2][station]).norm(), 1e-9);
    double least = 1.0;
    for (int k = 0; k <= 1000; ++k)
      least = std::min(least, (three.position(station, k / 1000.0) - three.lines[1][station]).norm());
    EXPECT_LT(least, 0.02) << "steps along the arc are 0.03 mm";
  }
  // if the profile is an arc of radius 20, 24 wide, the method is right
  exact.generator = [](double w) {
    const double half = std::asin(0.6), angle = half * (2.0 * w - 1.0);
    return Vector3d(0.0, 12.0 + 20.0 * std::sin(angle), 20.0 * (std::cos(angle) - std::cos(half)));
  };
  EXPECT_LT(offOf(exact, measuredLines(exact, 300, 0.0, 1)).largest, 1e-6);
}

TEST(EarlierMethod, IsOffByWhatThePlaneTells)
{
  // in the plane: the profile against the circle through (0, 0), (12, 5) and (24, 0)
  constexpr double rise = 5.0, radius = (12.0 * 12.0 + rise * rise) / (2.0 * rise);
  const ExactRidge exact = dieRidge();
  const auto inPlane = [&exact](double w) {
    const Vector3d p = exact.generator(w);
    return std::abs(std::hypot(p.y() - 12.0, p.z() - (rise - radius)) - radius);
  };
  const ThreeLines three = measuredLines(exact, 100, 0.0, 1);
  Off plane, swept;
  constexpr int stations = 10, across = 60;
  for (int j = 0; j <= across; ++j) {
    const double w = static_cast<double>(j) / across;
    take(inPlane(w), plane);
    for (int i = 0; i <= stations; ++i) {
      double least = 1e9;
      for (int k = 0; k <= 1000; ++k)
        least = std::min(least, (three.position(9 * static_cast<std::size_t>(i), k / 1000.0) - exact.position(9.0 * i / 99.0, w)).norm());
      take(least, swept);
    }
  }
  EXPECT_NEAR(plane.rms(), 0.64, 0.01);
  EXPECT_NEAR(plane.largest, 1.04, 0.01);
  EXPECT_NEAR(swept.rms(), plane.rms(), 0.002);
  EXPECT_NEAR(swept.largest, plane.largest, 0.002);
}

TEST(EarlierMethod, IsFartherOffThanARailAndAGenerator)
{
  const ExactRidge exact = dieRidge();
  const Off without_noise = offOf(exact, measuredLines(exact, 300, 0.0, 1));
  EXPECT_NEAR(without_noise.rms(), 0.617, 0.005) << "places of the arcs, not of the profile";
  EXPECT_NEAR(without_noise.largest, 1.02, 0.01);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Off theirs = offOf(exact, measuredLines(exact, 300, noise, 10 * seed));
    const auto surface =
        madeRidge(moved(exact.railPoints(300), noise, 2 * seed), moved(exact.generatorPoints(0.37, 60), noise, 2 * seed + 1));
    ASSERT_TRUE(surface);
    const Off ours = offOf(exact, *surface);
    EXPECT_NEAR(theirs.rms(), without_noise.rms(), 0.01);
    EXPECT_NEAR(theirs.largest, without_noise.largest, 0.06);
    EXPECT_LE(ours.rms(), 0.02);
    EXPECT_LE(ours.largest, 0.1);
    std::printf("seed %d, off: three lines, 900 points, %.3f mm rms, %.2f mm; rail and generator, 360 points, %.4f mm rms, %.3f mm\n",
                static_cast<int>(seed), theirs.rms(), theirs.largest, ours.rms(), ours.largest);
  }
}

TEST(EarlierMethod, TakesNearlyThreeTimesTheMeasuring)
{
  const ExactRidge exact = dieRidge();
  const double rail = lengthOf(exact.railPoints(2001)), generator = lengthOf(exact.generatorPoints(0.37, 2001));
  // 300 points a line are 2.14 mm apart
  const double apart = rail / 299.0;
  EXPECT_NEAR(apart, 2.14, 0.01);
  const std::size_t ours = 300 + pointsAt(apart, generator);
  EXPECT_EQ(ours, 313u);
  EXPECT_NEAR(static_cast<double>(ours) / 900.0, 0.35, 0.005);
  const double step = 2.0; // each line with its own length
  std::size_t theirs = 0;
  for (const double w : {0.0, 0.5, 1.0}) {
    std::vector<Vector3d> line;
    for (int i = 0; i <= 2000; ++i)
      line.push_back(exact.position(i / 2000.0, w));
    theirs += pointsAt(step, lengthOf(line));
  }
  EXPECT_NEAR(static_cast<double>(pointsAt(step, rail) + pointsAt(step, generator)) / static_cast<double>(theirs), 0.35, 0.005);
  std::printf("points: %zu and 900 at %.2f mm, %zu and %zu at %.2f mm\n", ours, apart, pointsAt(step, rail) + pointsAt(step, generator),
              theirs, step);
}

} // namespace ridge_earlier_method_test
