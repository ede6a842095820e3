// SPDX-License-Identifier: BSD-3-Clause
// Drive paths by section planes: on the plane, on the surface, evenly spaced, all of the surface near a pass.
#include "support/driven.h"

#include <array>
#include <set>

namespace drive_sections_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

Vector3d
flattened(const Vector3d& p)
{
  return {p.x(), p.y(), 0.0};
}

} // namespace

TEST(DriveSections, OfASphereCapLieOnPlanesAndSurface)
{
  const double radius = 60.0;
  const SurfacePtr cap = ball(radius, Region({circle({0, 0}, 30.0)}));
  const std::vector<Vector3d> points = sampleUniform(*cap, 30000, 1).points; // 0.3 mm apart
  for (const double angle : {0.0, 90.0, 37.0}) {
    const Driven run = driven(points, [&](Drive& drive) {
      drive.setStepOver(2.5);
      drive.setPointSpacing(0.8);
      drive.setPlaneDirection(angle);
    });
    ASSERT_EQ(run.passes.size(), 24u); // the cap is a little less than 60 wide
    EXPECT_NEAR(run.report.step_over, 2.5, 0.02);
    const double a = angle * M_PI / 180.0;
    const Vector3d along(std::cos(a), std::sin(a), 0.0), across(-std::sin(a), std::cos(a), 0.0);
    double low = INFINITY, high = -INFINITY;
    for (const Vector3d& p : points) {
      low = std::min(low, across.dot(p.cast<float>().cast<double>()));
      high = std::max(high, across.dot(p.cast<float>().cast<double>()));
    }
    for (std::size_t k = 0; k < run.passes.size(); ++k) {
      const DrivePass& pass = run.passes[k];
      EXPECT_FALSE(pass.closed);
      EXPECT_LE(largestStep(pass), 0.8 + 1e-9);
      const double plane = low + (high - low) * (k + 0.5) / 24.0;
      for (const DrivePoint& p : pass.points) {
        ASSERT_NEAR(across.dot(p.position), plane,
                    1e-5); // low and high may be points that are not in the triangulation
        ASSERT_LT(p.position.norm(), radius + 1e-4);
        ASSERT_GT(p.position.norm(), radius - 0.02); // sag of the longest edges
        ASSERT_EQ(p.axis, Vector3d::UnitZ());
        ASSERT_FALSE(p.asksForContact());
      }
      const Vector3d travel = pass.points.back().position - pass.points.front().position;
      EXPECT_GT(travel.dot(along) * (k % 2 == 0 ? 1.0 : -1.0), 0.0) << k; // to and fro
      const double chord = 2.0 * std::sqrt(900.0 - plane * plane);        // from rim to rim
      EXPECT_NEAR(travel.norm(), chord, 1.5);
    }
    double farthest = 0.0;
    for (std::size_t i = 0; i < points.size(); i += 20)
      farthest = std::max(farthest, distanceFrom(run.passes, points[i], flattened));
    EXPECT_LT(farthest, 0.5 * run.report.step_over + 0.65); // two spacings at the rim
  }
}

TEST(DriveSections, RunOneWayWhereAsked)
{
  const std::vector<Vector3d> points = sampleUniform(*flat(Region({rectangle(40.0, 20.0)})), 6000, 2).points;
  const Driven run = driven(points, [](Drive& drive) {
    drive.setStepOver(3.0);
    drive.setZigzag(false);
    drive.setPlaneDirection(Vector3d(-1.0, 0.0, 5.0)); // the component along the axis has no effect
  });
  EXPECT_EQ(run.passes.size(), 7u); // 20 / 3
  for (const DrivePass& pass : run.passes)
    EXPECT_NEAR((pass.points.back().position - pass.points.front().position).x(), -40.0, 1.0);
  EXPECT_NEAR(run.report.length, 7 * 40.0, 5.0);
}

TEST(DriveSections, AreCutByHolesButNotBySmallGaps)
{
  const SurfacePtr plate =
      flat(Region({rectangle(60.0, 40.0), circle({5.0, 0.0}, 8.0), circle({-20.0, 0.4}, 0.6)})); // points are 0.34 apart
  const Driven run = driven(sampleUniform(*plate, 20000, 3).points, [](Drive& drive) { drive.setStepOver(2.0); });
  std::multiset<int> at_row;
  for (const DrivePass& pass : run.passes)
    at_row.insert(static_cast<int>(std::floor(pass.points.front().position.y() / run.report.step_over)));
  for (int row = -10; row < 10; ++row) {
    const double y = (row + 0.5) * run.report.step_over;
    if (std::abs(std::abs(y) - 8.0) > 0.5)
      EXPECT_EQ(at_row.count(row), std::abs(y) < 8.0 ? 2u : 1u) << y;
  }
  for (std::size_t k = 0; k + 1 < run.passes.size(); ++k) // the pieces of a plane in the order of travel
    EXPECT_LT((run.passes[k + 1].points.front().position - run.passes[k].points.back().position).norm(), 17.5);
}

TEST(DriveSections, AreLinkedOnTheSurface)
{
  const SurfacePtr cap = ball(60.0, Region({circle({0, 0}, 30.0)}));
  const std::vector<Vector3d> points = sampleUniform(*cap, 30000, 1).points;
  const auto set = [](Drive& drive) {
    drive.setStepOver(2.5);
    drive.setPointSpacing(0.8);
  };
  const Driven apart = driven(points, set);
  const Driven run = driven(points, [&](Drive& drive) {
    set(drive);
    drive.setLinkRows(true);
  });
  EXPECT_EQ(apart.report.rows, 24U);
  EXPECT_EQ(apart.report.links, 0U);
  EXPECT_EQ(run.report.links + run.passes.size(), 24U);
  EXPECT_EQ(run.report.rows_apart + 1, run.passes.size());
  // The ends of the outermost two or three rows on a circle are more than two step-overs apart.
  EXPECT_GE(run.report.links, 18U);
  std::set<std::array<double, 3>> of_rows;
  for (const DrivePass& pass : apart.passes)
    for (const DrivePoint& p : pass.points)
      of_rows.insert({p.position.x(), p.position.y(), p.position.z()});
  std::size_t of_links = 0, kept = 0;
  for (const DrivePass& pass : run.passes) {
    EXPECT_LE(largestStep(pass), 0.8 + 1e-3);
    for (const DrivePoint& p : pass.points) {
      const bool is_row = of_rows.count({p.position.x(), p.position.y(), p.position.z()}) > 0;
      ++(is_row ? kept : of_links);
      if (is_row)
        continue;
      ASSERT_NEAR(p.position.norm(), 60.0, 2e-3);
      ASSERT_LT(p.position.head<2>().norm(), 30.3);
      ASSERT_EQ(p.axis, Vector3d::UnitZ());
    }
  }
  EXPECT_EQ(kept, of_rows.size());
  EXPECT_GE(of_links, 2 * run.report.links);
}

TEST(DriveSections, AreNotLinkedAcrossAHole)
{
  // A notch in the rim on the right, between two rows; a hole in the middle that three rows run into.
  const PlaneLoop notched{{-30, -20}, {30, -20}, {30, 0.3}, {24, 0.3}, {24, 2.8}, {30, 2.8}, {30, 20}, {-30, 20}};
  const SurfacePtr plate = flat(Region({notched, circle({-5.0, -8.0}, 4.5)}));
  const Driven run = driven(sampleUniform(*plate, 40000, 3).points, [](Drive& drive) { // 0.24 apart
    drive.setStepOver(3.2);
    drive.setLinkRows(true);
    drive.setPointSpacing(0.5);
  });
  std::printf("  %zu rows, %zu links, %zu apart\n", run.report.rows, run.report.links, run.report.rows_apart);
  EXPECT_EQ(run.report.rows, 13U);
  EXPECT_EQ(run.report.rows_apart, 4U); // one for each row across the hole, and one at the notch
  EXPECT_EQ(run.report.rows_apart + 1, run.passes.size());
  EXPECT_EQ(run.report.links, 11U);
  for (const DrivePass& pass : run.passes)
    for (std::size_t i = 0; i + 1 < pass.points.size(); ++i)
      for (const double share : {0.0, 0.25, 0.5, 0.75}) {
        const Vector3d x = pass.points[i].position + share * (pass.points[i + 1].position - pass.points[i].position);
        ASSERT_FALSE(x.x() > 24.4 && std::abs(x.y() - 1.55) < 0.9) << x.transpose();
        ASSERT_GT((x.head<2>() - Eigen::Vector2d(-5.0, -8.0)).norm(), 4.0) << x.transpose();
      }
}

TEST(DriveSections, StayWholeUnderNoiseOfTheSpacingAndSaySo)
{
  Sampled sampled = sampleUniform(*quadric(90.0, -60.0, Region({rectangle(60.0, 60.0)})), 14000, 6); // 0.5 apart
  const auto set = [](Drive& drive) { drive.setStepOver(1.0); };
  const Driven clean = driven(sampled.points, set);
  EXPECT_EQ(clean.passes.size(), 60u);
  EXPECT_TRUE(clean.report.warnings.empty());
  addNoise(sampled, 0.2, 7);
  const Driven noisy = driven(sampled.points, set);
  std::printf("  %zu passes, %zu short pieces left out\n", noisy.passes.size(), noisy.report.short_pieces);
  EXPECT_LE(noisy.passes.size(), 66u);
  ASSERT_EQ(noisy.report.warnings.size(), 1u);
  EXPECT_NE(noisy.report.warnings[0].text().find("smooth"), std::string::npos);
}

TEST(DriveSections, OfAClosedColumnAreRings)
{
  std::vector<Vector3d> points;
  Random random(4);
  for (int i = 0; i < 12000; ++i) {
    const double a = random.uniform(0.0, 2.0 * M_PI);
    points.emplace_back(15.0 * std::cos(a), random.uniform(-20.0, 20.0), 15.0 * std::sin(a));
  }
  const Driven run = driven(points, [](Drive& drive) { // planes across the column that contain the tool axis
    drive.setStepOver(4.0);
    drive.setPlaneDirection(0.0);
  });
  EXPECT_EQ(run.passes.size(), 10u);
  for (const DrivePass& pass : run.passes) {
    EXPECT_TRUE(pass.closed);
    EXPECT_LE(largestStep(pass), 1.0 + 1e-9);
    EXPECT_NEAR(pass.points.size(), 2.0 * M_PI * 15.0, 2.0);
    EXPECT_LT(pass.points.front().position.x(), -14.5); // starts where the surface starts along the passes
  }
}

TEST(DriveSections, FollowATiltedAxisAndTheFittedSurface)
{
  const SurfacePtr part = quadric(90.0, -60.0, Region({rectangle(40.0, 40.0)}));
  const Vector3d axis = Vector3d(0.3, 0.2, 1.0).normalized();
  const std::vector<Vector3d> points = sampleUniform(*part, 20000, 5).points;
  for (const DriveAxisMode mode : {DriveAxisMode::Fixed, DriveAxisMode::Surface, DriveAxisMode::LocalPlane}) {
    const Driven run = driven(points, [&](Drive& drive) {
      drive.setStepOver(3.0);
      drive.setAxis(5.0 * axis);
      drive.setPlaneDirection(30.0);
      drive.setAxisMode(mode);
    });
    double worst = 0.0;
    for (const DrivePass& pass : run.passes) {
      const Vector3d first = pass.points.front().position, last = pass.points.back().position;
      const Vector3d normal = axis.cross(last - first).normalized(); // of a plane that holds the axis
      for (const DrivePoint& p : pass.points) {
        ASSERT_NEAR(normal.dot(p.position - first), 0.0, 1e-9);
        ASSERT_NEAR(part->signedDistance(p.position), 0.0, 5e-3);
        if (mode == DriveAxisMode::Fixed)
          ASSERT_LT((p.axis - axis).norm(), 1e-12);
        else if (part->rimDistance(p.position) > 1.5)
          worst = std::max(worst, std::acos(std::min(1.0, p.axis.dot(part->normal(p.position)))));
      }
    }
    std::printf("  axes of mode %d: off the normal by %.5f rad, largest step %.3f degrees\n", static_cast<int>(mode), worst,
                run.report.largest_axis_step);
    EXPECT_LT(worst, mode == DriveAxisMode::LocalPlane ? 0.02 : 1e-3);
  }
}

} // namespace drive_sections_test
