// SPDX-License-Identifier: BSD-3-Clause
// Bisection of located passes, against dense samples of the swept cutter in the same cloud.
#include <pcl_spiral/cutter/impl/location_bisection.h>

#include "support/located.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace location_bisection_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double tolerance = 0.01;

std::vector<Vector3d>
waves(std::uint64_t seed)
{
  std::vector<Vector3d> points = sampleUniform(*flat(Region({rectangle(50.0, 50.0)})), 40000, seed).points;
  for (Vector3d& p : points)
    p.z() = 1.2 * std::sin(p.x() / 5.0) + 0.8 * std::cos((p.y() + 0.4 * p.x()) / 6.0);
  return points;
}

/** Lines over the waves, one point per 3 mm, with axes that vary by up to 20 degrees. */
std::vector<DrivePoints>
lines()
{
  std::vector<DrivePoints> passes;
  for (double y : {-8.0, 5.0}) {
    passes.emplace_back();
    for (double x = -15.0; x <= 15.0; x += 3.0)
      passes.back().push_back({{x, y, 10.0}, {0.36 * std::sin(x / 7.0), 0.2 * std::cos(x / 9.0), 1.0}, Vector3d::Zero()});
  }
  return passes;
}

struct Bisected {
  std::vector<ToolLocations> before, after;
  BisectionReport figures;
};

Bisected
bisected(const LocationSurface& surface, const CutterShape& shape)
{
  const CutterLocationEngine locator(surface, CutterProfile(shape), {});
  Bisected run;
  for (const DrivePoints& drive : lines()) {
    run.before.emplace_back();
    EXPECT_TRUE(locator.locate(drive, {}, run.before.back()).ok());
  }
  run.after = run.before;
  BisectionSettings settings;
  settings.tolerance = tolerance;
  const Status status = bisectLocations(locator, settings, {}, run.after, run.figures);
  EXPECT_TRUE(status.ok()) << status.message();
  return run;
}

/** Depth along the normal of the deepest point in the cutter along \p passes. \p points are in order of x. */
double
deepestOnTheWay(const std::vector<Vector3d>& points, const CutterProfile& cutter, const std::vector<ToolLocations>& passes)
{
  constexpr int steps = 6;
  double deepest = -1e300;
  for (const ToolLocations& pass : passes)
    for (std::size_t i = 0; i + 1 < pass.size(); ++i)
      for (int k = 0; k <= steps; ++k) {
        const CutterPlace at = onTheWay({pass[i].tip, pass[i].axis}, {pass[i + 1].tip, pass[i + 1].axis}, static_cast<double>(k) / steps);
        const double reach = cutter.radius() + 10.0 * at.axis.head<2>().norm();
        const auto begin =
            std::lower_bound(points.begin(), points.end(), at.tip.x() - reach, [](const Vector3d& p, double x) { return p.x() < x; });
        for (auto p = begin; p != points.end() && p->x() < at.tip.x() + reach; ++p)
          deepest = std::max(deepest, depthOf(*p, cutter, at));
      }
  return deepest;
}

Surface::ConstPtr
surfaceOf(const std::vector<Vector3d>& points)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(toCloud(points));
  Surface::ConstPtr surface;
  scanned.compute(surface);
  return surface;
}

} // namespace

TEST(LocationBisection, TheSweptCutterKeepsTheTolerance)
{
  std::vector<Vector3d> points = waves(1);
  std::sort(points.begin(), points.end(), [](const Vector3d& a, const Vector3d& b) { return a.x() < b.x(); });
  const LocationSurface surface(surfaceOf(points));
  const double sampling = 0.002; // error of the fitted surface
  for (const CutterShape& shape : all_kinds) {
    const CutterProfile cutter(shape);
    const CutterLocationEngine locator(surface, cutter, {});
    const Bisected run = bisected(surface, shape);
    EXPECT_EQ(run.figures.unresolved, 0u);
    EXPECT_LE(run.figures.largest_error, tolerance);
    const double before = deepestOnTheWay(points, cutter, run.before), after = deepestOnTheWay(points, cutter, run.after);
    std::printf("r %.1f: %zu locations, %zu put in; deepest on the way %.4f mm before, %.4f after\n", shape.corner_radius,
                2 * run.before[0].size(), run.figures.inserted, before, after);
    EXPECT_GT(before, 1.1 * tolerance);
    EXPECT_LE(after, tolerance + sampling);
    // No material is left either: at a quarter of each move the cutter is no higher above its contact than this.
    DrivePoints quarters;
    for (const ToolLocations& pass : run.after)
      for (std::size_t i = 0; i + 1 < pass.size(); ++i) {
        const CutterPlace at = onTheWay({pass[i].tip, pass[i].axis}, {pass[i + 1].tip, pass[i + 1].axis}, 0.25);
        quarters.push_back({at.tip, at.axis, Vector3d::Zero()});
      }
    ToolLocations touching;
    ASSERT_TRUE(locator.locate(quarters, {}, touching).ok());
    double left = 0.0;
    for (std::size_t i = 0; i < quarters.size(); ++i)
      left = std::max(left, (quarters[i].position - touching[i].tip).dot(touching[i].axis));
    EXPECT_LE(left, tolerance + sampling) << shape.corner_radius;
  }
}

TEST(LocationBisection, KeepsWhatItIsGivenAndEndsAtTheLimit)
{
  const LocationSurface surface(surfaceOf(waves(2)));
  const CutterLocationEngine locator(surface, CutterProfile(CutterShape::ball(4.0)), {});
  std::vector<ToolLocations> passes(1), tight;
  DrivePoints drive = lines()[0];
  drive[5].position.x() = 500.0; // no cloud there
  ASSERT_TRUE(locator.locate(drive, {}, passes[0]).ok());
  const ToolLocations given = passes[0];
  BisectionReport figures;
  BisectionSettings settings;
  settings.tolerance = 1e-5;
  settings.most_halvings = 2;
  ASSERT_TRUE(bisectLocations(locator, settings, {}, passes, figures).ok());
  EXPECT_EQ(figures.not_judged, 2u);
  EXPECT_GT(figures.unresolved, 0u);
  EXPECT_GT(figures.largest_error, settings.tolerance);
  EXPECT_EQ(passes[0].size(), given.size() + figures.inserted);
  std::size_t next = 0; // the given points are still there, in order
  for (const ToolLocation& location : passes[0])
    if (next < given.size() && (location.tip == given[next].tip || (next == 5 && location.state == LocationState::NoCloud)))
      ++next;
  EXPECT_EQ(next, given.size());
}

TEST(LocationBisection, RefusesAndCancels)
{
  const LocationSurface surface(surfaceOf(waves(3)));
  const CutterLocationEngine locator(surface, CutterProfile(CutterShape::ball(4.0)), {});
  std::vector<ToolLocations> passes(1);
  ASSERT_TRUE(locator.locate(lines()[0], {}, passes[0]).ok());
  const std::size_t before = passes[0].size();
  BisectionReport figures;
  EXPECT_EQ(bisectLocations(locator, {0.0, 12}, {}, passes, figures).code(), StatusCode::InvalidArgument);
  EXPECT_EQ(bisectLocations(locator, {0.01, 0}, {}, passes, figures).code(), StatusCode::InvalidArgument);
  const auto stop = [](double, const std::string&) { return false; };
  EXPECT_EQ(bisectLocations(locator, {0.01, 12}, stop, passes, figures).code(), StatusCode::Cancelled);
  EXPECT_EQ(passes[0].size(), before);
}

} // namespace location_bisection_test
