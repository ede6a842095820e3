// SPDX-License-Identifier: BSD-3-Clause
// Drive paths at equal distances from the boundary: on a disc, a spherical cap, over islands; and along
// curves.
#include "support/driven.h"

#include <set>

namespace drive_offsets_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

void
byOffsets(Drive& drive, double step)
{
  drive.setKind(DriveKind::BoundaryOffset);
  drive.setStepOver(step);
  drive.setPointSpacing(0.9);
}

double
farthestFrom(const Driven& run, const std::vector<Vector3d>& points)
{
  double farthest = 0.0;
  for (std::size_t i = 0; i < points.size(); i += 40)
    farthest = std::max(farthest, distanceFrom(run.passes, points[i], [](const Vector3d& p) { return p; }));
  return farthest;
}

} // namespace

TEST(DriveOffsets, OfADiscAreCirclesOfTheRadiiAskedFor)
{
  const double radius = 30.0;
  const std::vector<Vector3d> points = sampleUniform(*flat(Region({circle({0, 0}, radius)})), 30000, 1).points;
  const Driven run = driven(points, [](Drive& drive) { byOffsets(drive, 4.0); });
  ASSERT_EQ(run.passes.size(), 8u); // 30 / 4
  EXPECT_NEAR(run.report.step_over, radius / 8.0, 0.02);
  for (std::size_t k = 0; k < run.passes.size(); ++k) {
    const DrivePass& pass = run.passes[k];
    EXPECT_TRUE(pass.closed);
    EXPECT_LE(largestStep(pass), 0.9 + 1e-9);
    double turned = 0.0;
    for (std::size_t i = 0; i < pass.points.size(); ++i) {
      const Vector3d a = pass.points[i].position, b = pass.points[(i + 1) % pass.points.size()].position;
      ASSERT_NEAR(a.head<2>().norm(), radius * (1.0 - (k + 0.5) / 8.0), 0.1) << k;
      turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    EXPECT_NEAR(turned, 2.0 * M_PI, 1e-6); // the boundary on the right
    if (k > 0)                             // begins next to the start of the pass before
      EXPECT_LT((pass.points.front().position - run.passes[k - 1].points.front().position).norm(), 4.3);
  }
  EXPECT_LT(farthestFrom(run, points), 0.5 * run.report.step_over + 0.2);
}

TEST(DriveOffsets, OfASphericalCapKeepTheirDistanceAlongTheSurface)
{
  const double radius = 50.0, rim = 40.0, arc = radius * std::asin(rim / radius);
  const Driven run =
      driven(sampleUniform(*ball(radius, Region({circle({0, 0}, rim)})), 40000, 2).points, [](Drive& drive) { byOffsets(drive, 5.0); });
  ASSERT_EQ(run.passes.size(), 10u); // 46.4 / 5
  for (std::size_t k = 0; k < run.passes.size(); ++k)
    for (const DrivePoint& p : run.passes[k].points) {
      const double from_pole = radius * std::atan2(p.position.head<2>().norm(), p.position.z());
      ASSERT_NEAR(arc - from_pole, run.report.step_over * (k + 0.5), 0.25) << k;
    }
}

TEST(DriveOffsets, CoverIslandsWhereTheSurfaceParts)
{
  // Two squares of different size, joined by a neck: lines split there, and each part ends at its own depth.
  const PlaneLoop outline = {{-40, -20}, {0, -20}, {0, -3}, {12, -3}, {12, -13}, {38, -13},
                             {38, 13},   {12, 13}, {12, 3}, {0, 3},   {0, 20},   {-40, 20}};
  const std::vector<Vector3d> points = sampleUniform(*flat(Region({outline})), 20000, 3).points;
  for (const double step : {3.0, 4.0, 5.5}) {
    const Driven run = driven(points, [&](Drive& drive) { byOffsets(drive, step); });
    for (const DrivePass& pass : run.passes)
      EXPECT_TRUE(pass.closed);
    const double farthest = farthestFrom(run, points);
    std::printf("  step %.3f: %zu passes, farthest %.3f\n", run.report.step_over, run.passes.size(), farthest);
    // Corners: lines are mitred or round there, so corners of the outline are farther by up to sqrt 2.
    EXPECT_LT(farthest, 0.5 * std::sqrt(2.0) * run.report.step_over + 0.5);
    const double middle = distanceFrom(run.passes, {25.0, 0.0, 0.0}, [](const Vector3d& p) { return p; });
    EXPECT_LT(middle, 0.5 * run.report.step_over + 0.2); // 13 deep, between two lines of the larger square
    std::size_t inside_small = 0;                        // its inner lines, the last of them half a step or less from its middle
    for (const DrivePass& pass : run.passes)
      inside_small += std::all_of(pass.points.begin(), pass.points.end(), [](const DrivePoint& p) { return p.position.x() > 12.0; });
    EXPECT_GE(inside_small, static_cast<std::size_t>(13.0 / run.report.step_over - 1.0));
  }
}

TEST(DriveOffsets, AClosedSurfaceHasNone)
{
  Random random(4);
  std::vector<Vector3d> points;
  for (int i = 0; i < 5000; ++i)
    points.push_back(20.0 * Vector3d(random.normal(), random.normal(), random.normal()).normalized());
  const Driven run = driven(
      points, [](Drive& drive) { byOffsets(drive, 3.0); }, false);
  EXPECT_NE(run.status.message().find("closed"), std::string::npos) << run.status.message();
  EXPECT_TRUE(run.passes.empty());
}

TEST(DriveCurve, IsDividedByArcLength)
{
  const std::vector<Vector3d> points = sampleUniform(*flat(Region({circle({0, 0}, 20.0)})), 3000, 5).points;
  Polyline curve;
  for (int i = 0; i <= 1000; ++i) // unevenly along a circle of radius 10 at z = 2
    curve.emplace_back(10.0 * std::cos(1e-6 * i * i * M_PI), 10.0 * std::sin(1e-6 * i * i * M_PI), 2.0);
  const Driven open = driven(points, [&](Drive& drive) {
    drive.setKind(DriveKind::Curve);
    drive.setCurve(curve);
    drive.setPointSpacing(0.3);
    drive.setAxis({0.0, 1.0, 1.0});
  });
  ASSERT_EQ(open.passes.size(), 1u);
  EXPECT_EQ(open.passes[0].points.size(), 106u); // 10 pi / 0.3 steps
  EXPECT_EQ(open.passes[0].points.front().position, curve.front());
  EXPECT_EQ(open.passes[0].points.back().position, curve.back());
  for (std::size_t i = 0; i < open.passes[0].points.size(); ++i) {
    const DrivePoint& p = open.passes[0].points[i];
    ASSERT_NEAR(std::atan2(p.position.y(), p.position.x()), M_PI * i / 105.0, 1e-4);
    ASSERT_LT((p.axis - Vector3d(0.0, std::sqrt(0.5), std::sqrt(0.5))).norm(), 1e-12);
  }
  const Driven closed = driven(points, [&](Drive& drive) {
    drive.setKind(DriveKind::Curve);
    drive.setCurve({{5, 5, 0}, {-5, 5, 0}, {-5, -5, 0}, {5, -5, 0}}, true);
    drive.setPointSpacing(1.1);
    drive.setAxisMode(DriveAxisMode::Surface);
  });
  EXPECT_TRUE(closed.passes[0].closed);
  EXPECT_EQ(closed.passes[0].points.size(), 37u);
  for (const DrivePoint& p : closed.passes[0].points)
    EXPECT_LT((p.axis - Vector3d::UnitZ()).norm(), 1e-6);
}

} // namespace drive_offsets_test
