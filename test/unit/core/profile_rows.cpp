// SPDX-License-Identifier: BSD-3-Clause
// Ridges of any cutter on a slope: the width of a pass against the cutter itself, moved in small steps along two passes.
#include "core/profile_rows.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace profile_rows_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

/** A slope, and the passes over it. */
struct Slope {
  Vector3d normal, travel, across, planes; ///< across: in the slope; planes: normal of the planes of the rows
};

Slope
slopeOf(double degrees, double direction)
{
  const double lean = degrees * M_PI / 180.0, turn = direction * M_PI / 180.0;
  Slope slope;
  slope.normal = {std::sin(lean), 0.0, std::cos(lean)};
  const Vector3d flat(std::cos(turn), std::sin(turn), 0.0);
  slope.travel = (flat - Vector3d::UnitZ() * flat.dot(slope.normal) / slope.normal.z()).normalized(); // straight below a flat line
  slope.across = slope.travel.cross(slope.normal);
  slope.planes = flat.cross(Vector3d::UnitZ());
  return slope;
}

/** The distance of rows along the slope. */
double
widthOf(const CutterProfile& cutter, const Slope& slope, double height)
{
  const SurfaceBend flat{slope.normal, slope.travel, 0.0, 0.0};
  return profileRowDistance(flat, slope.planes, cutter, Vector3d::UnitZ(), height, RowsThrough::Centres, 0.0) /
         slope.normal.cross(slope.planes).norm();
}

/** The largest height above the slope, square to it, that two passes of the cutter leave between them. Heights are those of
 *  lines square to the slope, cut at 1e-3 of the length by every place of the cutter. */
double
ridgeOf(const CutterProfile& cutter, const Slope& slope, double apart)
{
  const Vector3d first = cutter.locate(Vector3d::Zero(), slope.normal, Vector3d::UnitZ()).tip;
  const double length = 2.2 * cutter.radius() / slope.normal.z();
  const auto cut = [&](const Vector3d& x) { // is x cut by any place of either pass?
    for (const double pass : {0.0, apart})
      for (int k = -400; k <= 400; ++k) {
        const Vector3d p = x - first - pass * slope.across - slope.travel * (length * k / 400.0);
        if (cutter.contains(p.head<2>().norm(), p.z(), -1e-9))
          return true;
      }
    return false;
  };
  double highest = 0.0;
  for (int k = 0; k <= 60; ++k) {
    const Vector3d foot = slope.across * (apart * k / 60.0);
    double low = 0.0, high = 20.0;
    if (cut(foot + highest * slope.normal + 1e-6 * slope.normal))
      continue;
    for (low = highest; high - low > 1e-5;) {
      const double middle = 0.5 * (low + high);
      (cut(foot + middle * slope.normal) ? high : low) = middle;
    }
    highest = high;
  }
  return highest;
}

} // namespace

TEST(ProfileRows, AWidthLeavesTheHeightOnASlope)
{
  constexpr double h = 0.05;
  for (const CutterShape& shape : {CutterShape::ball(5.0), CutterShape::bullNose(10.0, 2.0), CutterShape::bullNose(6.0, 0.5)})
    for (const double degrees : {0.0, 10.0, 30.0, 50.0})
      for (const double direction : {0.0, 35.0, 90.0}) {
        const CutterProfile cutter(shape);
        const Slope slope = slopeOf(degrees, direction);
        const double apart = widthOf(cutter, slope, h);
        const double left = ridgeOf(cutter, slope, apart);
        std::printf("  r %.1f of %.1f, %2.0f degrees, travel %2.0f: %.4f mm apart leave %.4f h\n", shape.corner_radius, shape.radius,
                    degrees, direction, apart, left / h);
        EXPECT_LE(left, 1.04 * h);
        EXPECT_GE(left, 0.9 * h);
      }
}

/** The teeth of a saw: rows along the slope's contour, D apart along it, leave D sin cos of a sharp edge. */
TEST(ProfileRows, AFlatEndLeavesTeeth)
{
  for (const double degrees : {5.0, 30.0, 45.0}) {
    const Slope slope = slopeOf(degrees, 90.0);
    const double apart = widthOf(CutterProfile(CutterShape::flatEnd(4.0)), slope, 0.05);
    const double lean = degrees * M_PI / 180.0;
    EXPECT_NEAR(apart, 0.05 / (std::sin(lean) * std::cos(lean)), 1e-3 * apart) << degrees;
  }
}

/** A ball's rows are those of the exact formula, whatever the surface and the planes. */
TEST(ProfileRows, ABallAgreesWithTheExactDistance)
{
  const CutterProfile ball(CutterShape::ball(5.0));
  for (const double k1 : {-0.1, 0.0, 0.01, 0.1})
    for (const double k2 : {-0.1, 0.05})
      for (const double turn : {0.0, 40.0, 90.0})
        for (const double lean : {0.0, 35.0})
          for (const RowsThrough through : {RowsThrough::Centres, RowsThrough::Contacts}) {
            if (through == RowsThrough::Contacts && k1 != k2 && turn != 0.0 && turn != 90.0)
              continue; // with torsion the contacts of the next row may be anywhere along it
            const Eigen::AngleAxisd about(lean * M_PI / 180.0, Vector3d::UnitY());
            const Vector3d direction(std::cos(turn * M_PI / 180.0), std::sin(turn * M_PI / 180.0), 0.0);
            const SurfaceBend bend{about * Vector3d::UnitZ(), about * direction, k1, k2};
            const double exact = rowDistance(bend, Vector3d::UnitX(), 5.0, 0.005, through);
            EXPECT_NEAR(profileRowDistance(bend, Vector3d::UnitX(), ball, Vector3d::UnitZ(), 0.005, through, 0.0), exact, 0.01 * exact)
                << k1 << ' ' << k2 << ' ' << turn << ' ' << lean << (through == RowsThrough::Centres ? " centres" : " contacts");
          }
}

TEST(ProfileRows, AWallTheCutterDoesNotReachSetsNoLimit)
{
  const SurfaceBend wall{Vector3d(0.0, 0.99, -0.1).normalized(), Vector3d::UnitX(), 0.0, 0.0};
  EXPECT_TRUE(std::isinf(profileRowDistance(wall, Vector3d::UnitX(), CutterProfile(CutterShape::bullNose(5.0, 1.0)), Vector3d::UnitZ(),
                                            0.01, RowsThrough::Centres, 0.0)));
}

} // namespace profile_rows_test
