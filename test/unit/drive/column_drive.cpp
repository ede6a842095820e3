// SPDX-License-Identifier: BSD-3-Clause
// A column of which every side hides a part, machined by a helix on its cylinder: it is covered completely, and the
// rotary axes move less than with the normals of local planes on the same path.
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/machine/impl/rotary_path.h>
#include <pcl_spiral/machine/machine.h>

#include "support/cutters.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace column_drive_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double height = 30.0, usual_noise = 0.02, radius = 4.0, step_over = 1.0, tolerance = 0.01, spacing = 0.5;
constexpr double overrun = 2.0; // R sin(lean), and half a step

/** Five twisted lobes and a waist. */
Vector3d
place(double angle, double z)
{
  const double r = 30.0 + 2.4 * std::sin(5.0 * angle + z / 12.0) + 3.0 * std::sin(z / 9.5);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

Vector3d
normalAt(double angle, double z)
{
  constexpr double d = 1e-5;
  const Vector3d round = place(angle + d, z) - place(angle - d, z), up = place(angle, z + d) - place(angle, z - d);
  return round.cross(up).normalized();
}

Cloud::Ptr
scanned(double noise = usual_noise)
{
  Random random(1);
  const Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i < 16000; ++i) {
    const double angle = random.uniform(0.0, 2.0 * M_PI), z = random.uniform(0.0, height);
    const Vector3d p = place(angle, z) + noise * random.normal() * normalAt(angle, z);
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  }
  return cloud;
}

DrivePasses
helix(const Cloud::ConstPtr& cloud, DriveAxisMode mode, double step = step_over)
{
  DrivePath<pcl::PointXYZ> drive;
  drive.setInputCloud(cloud);
  drive.setKind(DriveKind::Helix);
  drive.setStepOver(step);
  drive.setPointSpacing(spacing);
  drive.setCylinder({Vector3d::Zero(), Vector3d::UnitZ(), 0.0, height});
  drive.setAxisMode(mode);
  drive.setOverrun(overrun);
  DrivePasses passes;
  drive.compute(passes);
  EXPECT_TRUE(drive.getStatus().ok()) << drive.getStatus().message();
  EXPECT_EQ(passes.size(), 1U);
  return passes;
}

/** Largest step of an axis between neighbouring points, and the total variation of the steps. */
struct Calm {
  double largest = 0.0, variation = 0.0;
};

Calm
calmOf(const DrivePass& pass)
{
  ToolPoses poses;
  for (const DrivePoint& p : pass.points)
    poses.push_back({p.position, p.axis.normalized(), p.position, p.axis.normalized()});
  RotaryPath path;
  const Status status = rotaryPath(Kinematics(xyzacTrunnion()), poses, {1000.0, 0.0, 0.0}, path);
  EXPECT_TRUE(status.ok()) << status.message();
  Calm calm;
  const auto angle = [&](std::size_t i, int axis) { return axis == 0 ? path.locations[i].angles.first : path.locations[i].angles.second; };
  for (const int axis : {0, 1})
    for (std::size_t i = 1; i < poses.size(); ++i) {
      const double step = angle(i, axis) - angle(i - 1, axis);
      calm.largest = std::max(calm.largest, std::abs(step));
      if (i > 1)
        calm.variation += std::abs(step - (angle(i - 1, axis) - angle(i - 2, axis)));
    }
  return calm;
}

/** Largest steps of a fork head whose C, about z, carries B, about y; degrees. */
struct LargestSteps {
  double b = 0.0, c = 0.0;
};

LargestSteps
largestSteps(const std::vector<Vector3d>& axes)
{
  LargestSteps largest;
  const auto tilt = [&](std::size_t i) { return std::acos(axes[i].z()); };
  const auto turn = [&](std::size_t i) { return std::atan2(axes[i].y(), axes[i].x()); };
  for (std::size_t i = 1; i < axes.size(); ++i) {
    largest.b = std::max(largest.b, std::abs(tilt(i) - tilt(i - 1)) * 180.0 / M_PI);
    largest.c = std::max(largest.c, std::abs(std::remainder(turn(i) - turn(i - 1), 2.0 * M_PI)) * 180.0 / M_PI);
  }
  return largest;
}

/** Axes of a pass that was located, with locations added for \p path_tolerance; 0: none. */
std::vector<Vector3d>
locatedAxes(const Cloud::ConstPtr& cloud, const DrivePasses& passes, double path_tolerance)
{
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(cloud);
  location.setCutter(CutterShape::ball(radius));
  location.setDrivePasses(passes);
  location.setPathTolerance(path_tolerance);
  ToolLocations locations;
  location.compute(locations);
  EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
  std::vector<Vector3d> axes;
  for (const ToolLocation& l : locations)
    axes.push_back(l.axis);
  return axes;
}

/** Normal of the plane through the nearest points, found among all of them; out of the column. */
Vector3d
planeNormal(const Cloud& cloud, const Vector3d& at)
{
  constexpr std::size_t near = 32; // ScannedSurface::setKSearch
  std::vector<std::pair<double, Vector3d>> points;
  for (const pcl::PointXYZ& p : cloud)
    points.emplace_back((p.getVector3fMap().cast<double>() - at).squaredNorm(), p.getVector3fMap().cast<double>());
  std::nth_element(points.begin(), points.begin() + near, points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Vector3d mean = Vector3d::Zero();
  for (std::size_t i = 0; i < near; ++i)
    mean += points[i].second / near;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < near; ++i)
    spread += (points[i].second - mean) * (points[i].second - mean).transpose();
  const Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return normal.dot(Vector3d(at.x(), at.y(), 0.0)) < 0.0 ? Vector3d(-normal) : normal;
}

/** Mean radius of the exact column by area. */
double
meanRadius()
{
  double sum = 0.0, area = 0.0;
  for (double z = 0.05; z < height; z += 0.1)
    for (double angle = 0.0; angle < 2.0 * M_PI; angle += 0.01) {
      constexpr double d = 1e-5;
      const double element = (place(angle + d, z) - place(angle - d, z)).cross(place(angle, z + d) - place(angle, z - d)).norm();
      sum += element * place(angle, z).head<2>().norm();
      area += element;
    }
  return sum / area;
}

} // namespace

/** Locations that are added have the mean axis of their neighbours: they make steps no larger. */
TEST(ColumnDrive, LargestStepsOnTheExactColumn)
{
  constexpr double apart = 3.0;
  const Cloud::Ptr cloud = scanned(0.0);
  const DrivePasses driven = helix(cloud, DriveAxisMode::Cylinder, apart), planes = helix(cloud, DriveAxisMode::LocalPlane, apart);
  const LargestSteps even = largestSteps(locatedAxes(cloud, driven, tolerance));
  EXPECT_LT(even.b, 1e-6);
  const double steps_a_turn = 360.0 / even.c;
  EXPECT_NEAR(steps_a_turn, std::round(steps_a_turn), 1e-6);
  EXPECT_NEAR(steps_a_turn, 2.0 * M_PI * meanRadius() / spacing + 0.5, 1.5); // rounded up, from the points' mean radius

  std::vector<Vector3d> normals;
  for (const DrivePoint& p : planes[0].points)
    normals.push_back(planeNormal(*cloud, p.position));
  const LargestSteps expected = largestSteps(normals), found = largestSteps(locatedAxes(cloud, planes, 0.0)),
                     added = largestSteps(locatedAxes(cloud, planes, tolerance));
  EXPECT_NEAR(found.b, expected.b, 1e-3);
  EXPECT_NEAR(found.c, expected.c, 1e-3);
  EXPECT_LE(added.b, found.b + 1e-6);
  EXPECT_LE(added.c, found.c + 1e-6);
  std::printf("largest steps of B and C: %.3f and %.3f degrees with the cylinder, %.3f and %.3f with local planes\n", even.b, even.c,
              added.b, added.c);
}

TEST(ColumnDrive, RotaryAxesAreCalmerThanWithLocalPlanes)
{
  const Cloud::Ptr cloud = scanned();
  const Calm driven = calmOf(helix(cloud, DriveAxisMode::Cylinder)[0]);
  const Calm local = calmOf(helix(cloud, DriveAxisMode::LocalPlane)[0]);
  std::printf("largest rotary step %.3f degrees, with local planes %.3f; variation of the steps %.3f and %.1f turns\n",
              driven.largest * 180 / M_PI, local.largest * 180 / M_PI, driven.variation / (2 * M_PI), local.variation / (2 * M_PI));
  EXPECT_GE(local.largest, 5.0 * driven.largest);
  EXPECT_GE(local.variation, 5.0 * driven.variation);
}

TEST(ColumnDrive, HelixCoversTheWholeSurfaceWithoutAGouge)
{
  const Cloud::Ptr cloud = scanned();
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(cloud);
  location.setCutter(CutterShape::ball(radius));
  location.setDrivePasses(helix(cloud, DriveAxisMode::Cylinder));
  location.setPathTolerance(tolerance);
  std::vector<ToolLocations> passes;
  location.compute(passes);
  ASSERT_TRUE(location.getStatus().ok()) << location.getStatus().message();
  ASSERT_EQ(passes.size(), 1U);
  EXPECT_EQ(location.getBisectionReport().unresolved, 0U);

  // The ball's centre moves on a line from location to location: each place of the surface against the moves near it.
  std::vector<Vector3d> middles;
  for (const ToolLocation& l : passes[0])
    if (l.state != LocationState::NoCloud)
      middles.push_back(l.tip + radius * l.axis);
  Random random(2);
  double uncut = -1e9, cut = 1e9;
  for (int i = 0; i < 1500; ++i) {
    const double angle = random.uniform(0.0, 2.0 * M_PI), z = random.uniform(0.0, height);
    const Vector3d p = place(angle, z);
    double nearest = 1e9;
    for (std::size_t k = 1; k < middles.size(); ++k) {
      const Vector3d a = middles[k - 1], d = middles[k] - a;
      if (std::abs(a.z() - z) > 2.0 * radius)
        continue;
      const double t = d.squaredNorm() > 0.0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
      nearest = std::min(nearest, (p - a - t * d).norm());
    }
    uncut = std::max(uncut, nearest - radius);
    if (z > 1.0 && z < height - 1.0) // the last points are up to a spacing and a half inside the end
      cut = std::min(cut, nearest - radius);
  }
  // A ridge between turns: step^2 / 8 (1 / R + 1 / rho) on the most convex lobe along the column's axis.
  const double ridge = step_over * step_over / 8.0 * (1.0 / radius + 1.0 / 25.0);
  std::printf("ridges up to %.4f mm, cut up to %.4f mm\n", uncut, -cut);
  EXPECT_LT(uncut, 1.3 * ridge + tolerance + usual_noise);
  EXPECT_GT(cut, -tolerance - usual_noise);
}

} // namespace column_drive_test
