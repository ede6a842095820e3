// SPDX-License-Identifier: BSD-3-Clause
// Drive paths round columns: constant radius, exact pitch, radial axes, fitted axis; the whole surface
// is covered.
#include "support/driven.h"

#include <Eigen/Geometry>

namespace drive_rings_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

/** Points of a column about z from -height / 2 to height / 2, evenly over the area of its cylinder, then moved. */
std::vector<Vector3d>
column(const std::function<double(double)>& radius, double height, double sector, double noise, const Eigen::Isometry3d& motion,
       std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = random.uniform(-0.5 * height, 0.5 * height), a = random.uniform(0.0, sector);
    const double r = radius(z) + noise * random.normal();
    points.push_back(motion * Vector3d(r * std::cos(a), r * std::sin(a), z));
  }
  return points;
}

double
round20(double)
{
  return 20.0;
}
double
waisted(double z)
{
  return 20.0 + 0.008 * z * z - 2.0; // 18 in the middle, 23 at the ends: undercut from every side
}

/** Distance of points and axes from a ring about the axis. */
struct RingErrors {
  double radius = 0.0, axis = 0.0;
};

RingErrors
errorsOf(const DrivePasses& passes, const DriveColumn& column)
{
  RingErrors e;
  for (const DrivePass& pass : passes)
    for (const DrivePoint& p : pass.points) {
      const Vector3d x = p.position - column.cylinder.origin, d = column.cylinder.direction;
      const Vector3d out = x - d * d.dot(x);
      e.radius = std::max(e.radius, std::abs(out.norm() - column.radius));
      e.axis = std::max(e.axis, (p.axis - out.normalized()).norm());
    }
  return e;
}

} // namespace

TEST(DriveRings, TheAxisIsFoundUnderNoise)
{
  for (const std::uint64_t seed : {1, 2})
    for (const auto& radius : {round20, waisted})
      for (const double height : {50.0, 8.0}) {
        const Eigen::Isometry3d motion = randomMotion(seed, 200.0);
        const std::size_t count = static_cast<std::size_t>(2.0 * M_PI * 20.0 * height / 0.5);
        const Driven run = driven(column(radius, height, 2.0 * M_PI, 0.02, motion, count, seed), [](Drive& drive) {
          drive.setKind(DriveKind::Rings);
          drive.setStepOver(2.0);
        });
        ASSERT_TRUE(run.report.column && run.report.column->fitted);
        const DriveColumn& c = *run.report.column;
        const Vector3d z = motion.linear().col(2);
        const double angle = c.cylinder.direction.cross(z).norm();
        std::printf("  height %g: %.6f rad, %.4f mm off; normals miss by %.3f mm, radius %.3f\n", height, angle,
                    (c.cylinder.origin - motion.translation()).cross(z).norm(), c.normal_miss, c.radius);
        EXPECT_LT(angle, height > 10.0 ? 1e-3 : 3e-3);
        EXPECT_LT((c.cylinder.origin - motion.translation()).cross(z).norm(), 0.02);
        EXPECT_NEAR(c.cylinder.last - c.cylinder.first, height, 0.1);
        EXPECT_EQ(c.covered_angle, 360.0);
        EXPECT_EQ(run.passes.size(), static_cast<std::size_t>(std::ceil((c.cylinder.last - c.cylinder.first) / 2.0 - 1e-9)));
      }
}

TEST(DriveRings, RingsLieWhereTheyShould)
{
  const std::vector<Vector3d> points = column(round20, 30.0, 2.0 * M_PI, 0.0, Eigen::Isometry3d::Identity(), 12000, 4);
  const Driven run = driven(points, [](Drive& drive) {
    drive.setKind(DriveKind::Rings);
    drive.setStepOver(4.0);
    drive.setPointSpacing(1.5);
    drive.setCylinder({{0, 0, 3}, {0, 0, 7}, -18.0, 12.0});
  });
  EXPECT_FALSE(run.report.column->fitted);
  ASSERT_EQ(run.passes.size(), 8u); // 30 / 4
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_TRUE(run.passes[k].closed);
    EXPECT_EQ(run.passes[k].points.size(), 84u); // 2 pi 20 / 1.5
    for (const DrivePoint& p : run.passes[k].points)
      ASSERT_NEAR(p.position.z(), -15.0 + 3.75 * (k + 0.5), 1e-9);
    EXPECT_NEAR(run.passes[k].points.front().position.x(), 20.0, 1e-4);
  }
  const RingErrors e = errorsOf(run.passes, *run.report.column);
  EXPECT_LT(e.radius, 1e-9);
  EXPECT_LT(e.axis, 1e-9);
}

TEST(DriveRings, TheHelixClimbsOneStepATurnBetweenTwoRings)
{
  const Eigen::Isometry3d motion = randomMotion(5, 100.0);
  const Driven run = driven(column(waisted, 50.0, 2.0 * M_PI, 0.0, motion, 25000, 5), [](Drive& drive) {
    drive.setKind(DriveKind::Helix);
    drive.setStepOver(3.0);
    drive.setPointSpacing(0.7);
  });
  ASSERT_EQ(run.passes.size(), 1u);
  const DrivePass& pass = run.passes[0];
  EXPECT_FALSE(pass.closed);
  EXPECT_LE(largestStep(pass), 0.7 + 1e-9);
  const DriveColumn& c = *run.report.column;
  const RingErrors e = errorsOf(run.passes, c);
  EXPECT_LT(e.radius, 1e-9);
  EXPECT_LT(e.axis, 1e-9);
  const double pitch = run.report.step_over;
  EXPECT_NEAR(pitch, 50.0 / 17.0, 0.01);
  double turned = 0.0; // against heights: level, climbing, level
  const Vector3d d = c.cylinder.direction;
  for (std::size_t i = 0; i < pass.points.size(); ++i) {
    const Vector3d x = pass.points[i].position - c.cylinder.origin;
    if (i > 0) {
      const Vector3d a = pass.points[i - 1].axis, b = pass.points[i].axis;
      turned += std::atan2(d.dot(a.cross(b)), a.dot(b)) / (2.0 * M_PI);
    }
    const double climbed = pitch * std::clamp(turned - 1.0, 0.0, 16.0);
    ASSERT_NEAR(x.dot(d), c.cylinder.first + 0.5 * pitch + climbed, 1e-6) << i;
  }
  EXPECT_NEAR(turned, 18.0, 1e-9);
  for (const Vector3d& p : column(waisted, 50.0, 2.0 * M_PI, 0.0, motion, 500, 6)) { // seen on the cylinder
    const double along = d.dot(p - c.cylinder.origin);
    const double off = distanceFrom(run.passes, p, [&](const Vector3d& x) {
      const Vector3d y = x - c.cylinder.origin;
      return Vector3d(c.radius * (y - d * d.dot(y)).normalized() + d * d.dot(y));
    });
    ASSERT_LT(off, 0.5 * pitch + 0.02) << along;
  }
}

TEST(DriveRings, ASectorIsRunInArcsAndRefusesAHelix)
{
  const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();
  const std::vector<Vector3d> points = column(waisted, 40.0, 2.0 * M_PI / 3.0, 0.0, still, 9000, 7);
  const Driven run = driven(points, [](Drive& drive) {
    drive.setKind(DriveKind::Rings);
    drive.setStepOver(4.0);
  });
  const DriveColumn& c = *run.report.column;
  EXPECT_LT(c.cylinder.direction.cross(Vector3d::UnitZ()).norm(), 3e-3);
  EXPECT_NEAR(c.covered_angle, 120.0, 1.0);
  ASSERT_EQ(run.passes.size(), 10u);
  for (std::size_t k = 0; k < run.passes.size(); ++k) {
    EXPECT_FALSE(run.passes[k].closed);
    const Vector3d first = run.passes[k].points.front().position, last = run.passes[k].points.back().position;
    EXPECT_GT((k % 2 == 0 ? 1.0 : -1.0) * (first.x() - last.x()),
              20.0); // to and fro between 0 and 120 degrees
  }
  const Driven helix = driven(
      points,
      [](Drive& drive) {
        drive.setKind(DriveKind::Helix);
        drive.setStepOver(4.0);
      },
      false);
  EXPECT_NE(helix.status.message().find("degrees about the axis"), std::string::npos);
  EXPECT_NE(helix.status.message().find("rings"), std::string::npos);
}

TEST(DriveRings, WhatIsNoColumnIsRefused)
{
  const std::pair<const char*, SurfacePtr> parts[] = {
      {"plate", flat(Region({rectangle(60.0, 30.0)}))},
      {"ball", ball(40.0, Region({circle({0, 0}, 30.0)}))},
      {"dome", spheroidCap(40.0, 20.0)},
      {"saddle", quadric(90.0, -60.0, Region({circle({0, 0}, 30.0)}))},
  };
  for (const auto& [name, part] : parts) {
    const Driven run = driven(
        sampleUniform(*part, 8000, 8).points,
        [](Drive& drive) {
          drive.setKind(DriveKind::Helix);
          drive.setStepOver(3.0);
        },
        false);
    std::printf("  %s: %s\n", name, run.status.message().c_str());
    EXPECT_NE(run.status.message().find("column"), std::string::npos);
    EXPECT_TRUE(run.passes.empty());
  }
}

TEST(DriveRings, AWholeBallIsRefused)
{
  Random random(12);
  std::vector<Vector3d> points;
  for (int i = 0; i < 8000; ++i)
    points.push_back(30.0 * Vector3d(random.normal(), random.normal(), random.normal()).normalized());
  const Driven run = driven(
      points,
      [](Drive& drive) {
        drive.setKind(DriveKind::Rings);
        drive.setStepOver(3.0);
      },
      false);
  EXPECT_NE(run.status.message().find("do not define an axis"), std::string::npos) << run.status.message();
}

TEST(DriveRings, SurfaceAxesAreNormalsAlsoFarOffTheCylinder)
{
  const std::vector<Vector3d> points = column(waisted, 50.0, 2.0 * M_PI, 0.0, Eigen::Isometry3d::Identity(), 25000, 9);
  double step[3];
  const DriveAxisMode modes[] = {DriveAxisMode::Cylinder, DriveAxisMode::Surface, DriveAxisMode::LocalPlane};
  for (int m = 0; m < 3; ++m) {
    const Driven run = driven(points, [&](Drive& drive) {
      drive.setKind(DriveKind::Helix);
      drive.setStepOver(3.0);
      drive.setAxisMode(modes[m]);
    });
    step[m] = run.report.largest_axis_step;
    EXPECT_EQ(run.report.axes_from_neighbours, 0u);
    if (modes[m] != DriveAxisMode::Surface)
      continue;
    double worst = 0.0;
    for (const DrivePoint& p : run.passes[0].points) {
      // The normal at the foot: the line back along the axis is perpendicular to the profile.
      double best = INFINITY, slope = 0.0;
      const double r = p.position.head<2>().norm();
      for (double z = -24.0; z <= 24.0; z += 0.001)
        if (const double d = std::hypot(r - waisted(z), p.position.z() - z); d < best) {
          best = d;
          slope = 0.016 * z;
        }
      const Vector3d out(p.position.x() / r, p.position.y() / r, 0.0);
      if (std::abs(p.position.z()) < 22.0)
        worst = std::max(worst, (p.axis - (out - slope * Vector3d::UnitZ()).normalized()).norm());
    }
    std::printf("  normals off by %.5f rad\n", worst);
    EXPECT_LT(worst, 3e-3);
  }
  std::printf("  largest steps: cylinder %.3f, surface %.3f, local planes %.3f degrees\n", step[0], step[1], step[2]);
  EXPECT_GT(step[2], 1.2 * step[0]);
}

} // namespace drive_rings_test
