// SPDX-License-Identifier: BSD-3-Clause
// Cutter locations on clouds of known surfaces: exact on planes and spheres, without gouges, with correct states where
// the scan ends.
#include <pcl_spiral/cutter/cutter_location.h>

#include "support/located.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cutter_location_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

// The published case, and every other cutter: axis not along the plane's normal, the tip in closed form.
TEST(CutterLocation, IsExactOnATiltedPlane)
{
  const SurfacePtr plane = flat(Region({rectangle(30.0, 30.0)}));
  Sampled sampled = sampleUniform(*plane, 12000, 1);
  const Eigen::Isometry3d motion = Eigen::Isometry3d(Eigen::AngleAxisd(0.6, Vector3d(1, 2, 0.5).normalized()));
  for (Vector3d& p : sampled.points)
    p = motion * p;
  const auto cloud = toCloud(sampled.points);
  for (const CutterShape& shape : all_kinds) {
    const CutterProfile cutter(shape);
    DrivePoints drive = drivePoints(*plane, 300, 45.0, 7.0, false, 2);
    for (DrivePoint& d : drive)
      d = {motion * d.position, motion.linear() * d.axis, Vector3d::Zero()};
    const Located run = located(cloud, shape, drive);
    EXPECT_EQ(run.figures.count(LocationBasis::FittedSurface), drive.size());
    for (std::size_t i = 0; i < drive.size(); ++i) {
      // Down the axis to the contact: tip = P + s v, with the contact of locate() on the plane.
      const Vector3d n = motion.linear() * Vector3d::UnitZ(), v = drive[i].axis;
      const CutterContact c = cutter.locate(Vector3d::Zero(), n, v);
      const double s = (c.tip - drive[i].position).dot(n) / v.dot(n);
      ASSERT_LT((run.locations[i].tip - drive[i].position - s * v).norm(), 1e-6) << i << ' ' << shape.flank_angle;
      ASSERT_EQ(run.locations[i].state, LocationState::Touching);
      ASSERT_NEAR(run.locations[i].contact.dot(n), 0.0, 1e-6);
    }
  }
}

// A ball over a sphere, the axis at l from its centre: the ball's centre is sqrt((rho + R)^2 - l^2) high.
TEST(CutterLocation, ABallOnASphereStandsWhereItShould)
{
  const double rho = 10.0, R = 2.0; // small, for single precision
  const SurfacePtr sphere = test::ball(rho, Region({circle({0, 0}, 5.0)}));
  const auto cloud = toCloud(sampleUniform(*sphere, 40000, 3).points);
  Random random(4);
  DrivePoints drive;
  for (int i = 0; i < 1000; ++i) {
    const double l = 3.5 * std::sqrt(random.uniform()), a = random.uniform(0.0, 2.0 * M_PI);
    drive.push_back({{l * std::cos(a), l * std::sin(a), 12.0}, Vector3d::UnitZ(), Vector3d::Zero()});
  }
  const Located fitted = located(cloud, CutterShape::ball(R), drive);
  const Located points = located(cloud, CutterShape::ball(R), drive, Evaluation::Points);
  double worst = 0.0, worst_points = 0.0;
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const double l2 = drive[i].position.head<2>().squaredNorm(), expected = std::sqrt((rho + R) * (rho + R) - l2) - R;
    worst = std::max(worst, std::abs(fitted.locations[i].tip.z() - expected));
    worst_points = std::max(worst_points, expected - points.locations[i].tip.z());
    ASSERT_LT(points.locations[i].tip.z(), expected + 1e-5);
    ASSERT_LE(expected - points.locations[i].tip.z(), points.locations[i].gap_bound + 1e-5);
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_GT(worst_points, 100.0 * worst); // the reason for evaluation on the surface
  RecordProperty("fitted", std::to_string(worst));
  RecordProperty("points", std::to_string(worst_points));
}

TEST(CutterLocation, OnTheContactOfAConvexPartEveryCutterReachesIt)
{
  const SurfacePtr part = quadric(-80.0, -150.0, Region({circle({0, 0}, 40.0)}));
  const auto cloud = toCloud(sampleUniform(*part, 40000, 5).points);
  for (const CutterShape& shape : all_kinds) {
    const DrivePoints drive = drivePoints(*part, 300, 50.0, 22.0, true, 6);
    const Located run = located(cloud, shape, drive);
    EXPECT_EQ(run.figures.count(LocationState::Reached), drive.size()) << shape.flank_angle;
    EXPECT_EQ(run.figures.over_rim, 0u);
    for (std::size_t i = 0; i < drive.size(); ++i) {
      ASSERT_NEAR(run.locations[i].lift, 0.0, 1e-4);
      const CutterContact c = CutterProfile(shape).locate(drive[i].position, drive[i].normal, drive[i].axis);
      ASSERT_LT((run.locations[i].tip - c.tip).norm(), 1e-4);
    }
  }
}

TEST(CutterLocation, ABallTooLargeForABowlIsLiftedByWhatItMisses)
{
  const double bowl_radius = 8.0, R = 10.0; // a trough along y
  const SurfacePtr trough = quadric(bowl_radius, 1e9, Region({rectangle(24.0, 60.0)}));
  const auto cloud = toCloud(sampleUniform(*trough, 40000, 7).points);
  const Located large = located(cloud, CutterShape::ball(R), {{Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitZ()}});
  const ToolLocation& location = large.locations[0];
  EXPECT_EQ(location.state, LocationState::Lifted);
  // The ball touches both sides, at x^2 = R^2 - a^2: its centre is R^2 / (2 a) + a / 2 high.
  EXPECT_NEAR(location.lift, R * R / (2.0 * bowl_radius) + 0.5 * bowl_radius - R, 1e-3);
  EXPECT_NEAR(std::abs(location.contact.x()), std::sqrt(R * R - bowl_radius * bowl_radius), 0.05);
  const Located small = located(cloud, CutterShape::ball(5.0), {{Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitZ()}});
  EXPECT_EQ(small.locations[0].state, LocationState::Reached);
}

TEST(CutterLocation, SaysWhereTheScanEnds)
{
  const SurfacePtr plane = flat(Region({rectangle(60.0, 60.0)}));
  const auto cloud = toCloud(sampleUniform(*plane, 12000, 8).points);
  const Vector3d up = Vector3d::UnitZ();
  const CutterShape cutter = CutterShape::ball(4.0);
  const Located run = located(cloud, cutter,
                              {{{0, 0, 0}, up, up},  // well inside
                               {{28, 0, 0}, up, up}, // partly off
                               {{40, 0, 0}, up, up}, // off
                               {{0, 0, 5}, up, up},  // above the scan
                               {{0, 0, 0}, -up, up}, // from below
                               {{40, 0, 0}, up, Vector3d::Zero()}});
  EXPECT_EQ(run.locations[0].state, LocationState::Reached);
  EXPECT_FALSE(run.locations[0].over_rim);
  EXPECT_EQ(run.locations[1].state, LocationState::Reached);
  EXPECT_TRUE(run.locations[1].over_rim);
  EXPECT_NEAR(run.locations[1].rim_clearance, 4.0 - std::sqrt(12.0), 0.15); // the rim is 2 from the axis
  EXPECT_EQ(run.locations[2].state, LocationState::NoCloud);
  EXPECT_TRUE(run.locations[2].tip.hasNaN());
  EXPECT_EQ(run.locations[3].state, LocationState::Clear);
  EXPECT_NEAR(run.locations[3].lift, -5.0, 1e-4);
  EXPECT_NEAR(run.locations[3].tip.z(), 5.0, 1e-9);
  EXPECT_EQ(run.locations[4].state, LocationState::Unreachable);
  EXPECT_EQ(run.locations[5].state, LocationState::NoCloud);
  EXPECT_EQ(run.figures.count(LocationState::NoCloud), 2u);
  EXPECT_EQ(run.figures.over_rim, 1u);
  EXPECT_EQ(run.figures.warnings.size(), 3u);
}

TEST(CutterLocation, AHoleInTheScanIsNoPlaceToSinkInto)
{
  const SurfacePtr plane = flat(Region({rectangle(60.0, 60.0), circle({0, 0}, 6.0)}));
  const auto cloud = toCloud(sampleUniform(*plane, 12000, 9).points);
  const Vector3d up = Vector3d::UnitZ();
  const Located run = located(cloud, CutterShape::ball(8.0), {{{0, 0, 0}, up, up}, {{0, 0, 0}, up, Vector3d::Zero()}});
  EXPECT_EQ(run.locations[0].state,
            LocationState::Clear); // stays on the contact, because there are no points in the hole
  EXPECT_NEAR(run.locations[0].tip.z(), 0.0, 1e-9);
  EXPECT_TRUE(run.locations[0].over_rim);
  EXPECT_EQ(run.locations[1].state, LocationState::Touching);
  EXPECT_LT(run.locations[1].tip.z(), -2.0);
  EXPECT_TRUE(run.locations[1].over_rim);
}

// A column that no plane shows completely: machined all round along a helix with radial axes.
TEST(CutterLocation, AColumnIsFollowedAllRound)
{
  const double R = 5.0;
  const auto radius = [](double z) { return 30.0 + 4.0 * std::sin(z / 8.0); };
  std::vector<Vector3d> points;
  Random random(22);
  for (int i = 0; i < 60000; ++i) {
    const double z = random.uniform(-50.0, 50.0), a = random.uniform(0.0, 2.0 * M_PI);
    points.emplace_back(radius(z) * std::cos(a), radius(z) * std::sin(a), z);
  }
  DrivePoints drive;
  for (double z = -40.0; z <= 40.0; z += 0.05)
    drive.push_back({{40.0 * std::cos(z), 40.0 * std::sin(z), z}, {std::cos(z), std::sin(z), 0.0}, {0, 0, 0}});
  const Located run = located(toCloud(points), CutterShape::ball(R), drive);
  EXPECT_EQ(run.figures.count(LocationBasis::FittedSurface), drive.size());
  for (std::size_t i = 0; i < drive.size(); ++i) {
    double expected = 0.0; // in the plane through the axis; across it the column is round
    for (double d = -R; d <= R; d += 1e-3)
      expected = std::max(expected, radius(drive[i].position.z() + d) - R + std::sqrt(R * R - d * d));
    ASSERT_NEAR(run.locations[i].tip.head<2>().norm(), expected, 2e-3) << i; // the error of the quadrics
    ASSERT_NEAR(run.locations[i].tip.head<2>().normalized().dot(drive[i].axis.head<2>()), 1.0, 1e-9);
  }
}

TEST(CutterLocation, NoPointOfTwentyFreeFormCloudsLiesInTheCutter)
{
  Random random(10);
  double worst = 0.0, worst_noiseless = 0.0;
  for (int k = 0; k < 20; ++k) {
    const double a = random.uniform(0.5, 3.0), b = random.uniform(0.5, 3.0), p = random.uniform(0.1, 0.25);
    const double q = random.uniform(0.1, 0.25), shift = random.uniform(0.0, 6.0);
    std::vector<Vector3d> points;
    for (int i = 0; i < 12000; ++i) {
      const double x = random.uniform(-30, 30), y = random.uniform(-30, 30);
      points.emplace_back(x, y, a * std::sin(p * x + 0.5 * q * y) + b * std::cos(q * y + shift));
    }
    const double noise = k % 4 == 3 ? 0.01 : 0.0;
    for (Vector3d& point : points)
      point.z() += noise * random.normal();
    for (Vector3d& point : points)
      point = point.cast<float>().cast<double>();
    const CutterShape shape = k < 6 ? all_kinds[k] : randomCutter(random);
    DrivePoints drive;
    for (int i = 0; i < 40; ++i)
      drive.push_back(
          {{random.uniform(-25, 25), random.uniform(-25, 25), 0.0}, leaning(Vector3d::UnitZ(), 30.0, random), Vector3d::Zero()});
    CutterLocation<pcl::PointXYZ> location;
    location.setInputCloud(toCloud(points));
    location.setCutter(shape);
    location.setDrivePoints(drive);
    for (const Evaluation evaluation : {Evaluation::FittedSurface, Evaluation::PointsAndBound, Evaluation::Points}) {
      Located run;
      location.setEvaluation(evaluation);
      location.compute(run.locations);
      ASSERT_EQ(run.locations.size(), drive.size());
      run.figures = location.getReport();
      location.setLocationSurface(location.getLocationSurface());
      const CutterProfile cutter(shape);
      for (const ToolLocation& location : run.locations) {
        if (location.state == LocationState::NoCloud)
          continue;
        const double depth = deepest(points, cutter, location);
        if (evaluation != Evaluation::FittedSurface) // on the points, or above
          ASSERT_LT(depth, 1e-9) << k;
        else { // below a point by at most the allowance for noise
          const double share = location.normal.isZero(0.0) ? 1.0 : std::max(0.2, location.normal.dot(location.axis));
          ASSERT_LT(depth, run.figures.noise_allowance / share + 1e-9) << k;
          ASSERT_NEAR(depth, std::max(0.0, -location.gap) - std::max(0.0, location.gap), 1e-6) << k;
        }
        (noise > 0.0 ? worst : worst_noiseless) = std::max(noise > 0.0 ? worst : worst_noiseless, depth);
      }
    }
  }
  EXPECT_LT(worst_noiseless, 1e-3);
  EXPECT_LT(worst, 0.05); // five times the noise
}

// On the surface itself, which the points only sample: a cutter located on the fit does not go into it.
TEST(CutterLocation, TheTrueSurfaceIsNotCutInto)
{
  const SurfacePtr part = quadric(90.0, -60.0, Region({circle({0, 0}, 30.0)}));
  const auto cloud = toCloud(sampleUniform(*part, 12000, 11).points);
  const std::vector<Vector3d> dense = sampleUniform(*part, 100000, 12).points;
  for (const CutterShape& shape : all_kinds) {
    const DrivePoints drive = drivePoints(*part, 25, 35.0, 10.0, false, 13);
    const CutterProfile cutter(shape);
    const Located fitted = located(cloud, shape, drive), points = located(cloud, shape, drive, Evaluation::Points);
    double sunk = 0.0, sunk_points = 0.0;
    for (std::size_t i = 0; i < drive.size(); ++i) {
      sunk = std::max(sunk, deepest(dense, cutter, fitted.locations[i]));
      const double depth = deepest(dense, cutter, points.locations[i]);
      sunk_points = std::max(sunk_points, depth);
      ASSERT_LE(depth, points.locations[i].gap_bound + 1e-5);
      // Its distance from these points is the depth it would have between them.
      ASSERT_GT(deepest(dense, cutter, fitted.locations[i]), shape.corner_radius > 0.0 ? -0.01 : -0.08);
    }
    EXPECT_LT(sunk, 1e-4) << shape.radius << ' ' << shape.corner_radius << ' ' << shape.flank_angle;
    EXPECT_GT(sunk_points, sunk);
  }
}

} // namespace cutter_location_test
