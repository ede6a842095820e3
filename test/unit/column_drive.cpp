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

#include <algorithm>
#include <cmath>

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double height = 30.0, noise = 0.02, radius = 4.0, step_over = 1.0, tolerance = 0.01;
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
scanned()
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
helix(const Cloud::ConstPtr& cloud, DriveAxisMode mode)
{
  DrivePath<pcl::PointXYZ> drive;
  drive.setInputCloud(cloud);
  drive.setKind(DriveKind::Helix);
  drive.setStepOver(step_over);
  drive.setPointSpacing(0.5);
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

} // namespace

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
  EXPECT_EQ(location.getBisectionFigures().unresolved, 0U);

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
  EXPECT_LT(uncut, 1.3 * ridge + tolerance + noise);
  EXPECT_GT(cut, -tolerance - noise);
}
