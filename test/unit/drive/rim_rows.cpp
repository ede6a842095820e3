// SPDX-License-Identifier: BSD-3-Clause
// Rows along the rim of a clean scan are located on the fitted surface, or on its edge: contacts, normals and balls by the exact surface.
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include "core/angle_between.h"
#include "support/judged_meshes.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rim_rows_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double half = 30.0, radius = 5.0, spacing = 0.7; // mm; of 7,500 points

template <typename Height>
ToolLocations
rowsOver(Height height, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Vector3d> points;
  for (int i = 0; i < 7500; ++i) {
    const double x = random.uniform(-half, half), y = random.uniform(-half, half);
    points.emplace_back(x, y, height(x, y));
  }
  DrivePath<pcl::PointXYZ> drive;
  drive.setInputCloud(toCloud(points));
  drive.setStepOver(0.9);
  DrivePasses passes;
  drive.compute(passes);
  EXPECT_TRUE(drive.getStatus().ok()) << drive.getStatus().message();
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(toCloud(points));
  location.setCutter(CutterShape::ball(radius));
  location.setDrivePasses(passes);
  ToolLocations locations;
  location.compute(locations);
  EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
  return locations;
}

/** How deep a ball about \p centre is in the surface over the scanned square. */
template <typename Height>
double
depthIn(Height height, const Vector3d& centre)
{
  constexpr double step = 0.25;
  double nearest = 1e9;
  for (double x = std::max(-half, centre.x() - radius); x <= std::min(half, centre.x() + radius); x += step)
    for (double y = std::max(-half, centre.y() - radius); y <= std::min(half, centre.y() + radius); y += step)
      nearest = std::min(nearest, (Vector3d(x, y, height(x, y)) - centre).norm());
  return radius - nearest;
}

template <typename Height>
void
expectOnSurface(Height height, std::uint64_t seed)
{
  std::size_t at_rim = 0;
  for (const ToolLocation& l : rowsOver(height, seed)) {
    ASSERT_EQ(l.basis, LocationBasis::FittedSurface) << l.tip.transpose();
    ASSERT_LT((l.contact + radius * (l.normal - l.axis) - l.tip).norm(), 1e-6);
    const Vector3d normal = heightNormal(height, l.contact.x(), l.contact.y());
    ASSERT_NEAR((l.contact.z() - height(l.contact.x(), l.contact.y())) * normal.z(), 0.0, 0.003) << l.contact.transpose();
    const double beyond = l.contact.head<2>().cwiseAbs().maxCoeff() - half;
    ASSERT_LT(beyond, 0.8 * spacing) << l.contact.transpose(); // half a spacing as it is there, where points are at random
    if (beyond < 0.0)
      ASSERT_LT(angleBetween(l.normal, normal), 0.002) << l.contact.transpose();
    else {
      ++at_rim;
      ASSERT_LT(depthIn(height, l.contact + radius * l.normal), 0.003) << l.contact.transpose();
    }
  }
  EXPECT_GT(at_rim, 20U);
}

} // namespace

TEST(RimRows, OfPanelsBowlsAndSaddlesAreOnTheSurface)
{
  expectOnSurface([](double x, double y) { return 8.0 * std::sin(x / 40.0) + y * y / 400.0; }, 1);
  expectOnSurface([](double x, double y) { return (x * x + y * y) / 150.0; }, 2);
  expectOnSurface([](double x, double y) { return (x * x - y * y) / 160.0; }, 3);
}

} // namespace rim_rows_test
