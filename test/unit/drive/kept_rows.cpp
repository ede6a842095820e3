// SPDX-License-Identifier: BSD-3-Clause
// Rows of a scan that keep the scallop height: a ball moved down along them, and the heights it leaves.
#include "support/driven.h"
#include "support/left_heights.h"

#include <pcl_spiral/cutter/cutter_location.h>

namespace kept_rows_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double radius = 5.0, height = 0.01;

/** The passes of a ball, located on the scan. */
CheckedPath
ballPath(const std::vector<Vector3d>& scan, const DrivePasses& passes)
{
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(toCloud(scan));
  location.setCutter({radius, radius, 0.0, 0.0});
  location.setDrivePasses(passes);
  location.setPathTolerance(5e-4);
  std::vector<ToolLocations> located;
  location.compute(located);
  EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
  CheckedPath path;
  for (const ToolLocations& pass : located) {
    if (path.size() > 0)
      path.lifted_to.push_back(path.size());
    for (const ToolLocation& at : pass) { // only the middle counts
      path.contacts.push_back(at.tip);
      path.normals.push_back(at.axis);
    }
  }
  return path;
}

/** Heights left 2 mm and more inside the square from the origin, in h: at 99 % and at 99.9 %. */
std::pair<double, double>
heightsLeftBy(const AnalyticSurface& surface, const CheckedPath& path, double size)
{
  std::vector<double> heights;
  for (const StockSample& s : heightsLeft(surface, path, {radius, height, 5.0, 2}, 20000, 3)) {
    const Vector2d u = s.x.head<2>();
    if (u.minCoeff() > 2.0 && u.maxCoeff() < size - 2.0)
      heights.push_back(s.stock / height);
  }
  EXPECT_GT(heights.size(), 10000U);
  return {quantile(heights, 0.99), quantile(heights, 0.999)};
}

} // namespace

TEST(KeptRows, LeaveTheScallopOnAScanOfTheLandform)
{
  constexpr double size = 40.0;
  const SurfacePtr land = landform(size);
  const std::vector<Vector3d> scan = sampleUniform(*land, 10000, 4).points; // 0.4 mm apart
  for (const double direction : {0.0, 60.0}) {
    std::size_t even = 0;
    for (const DriveRows rows : {DriveRows::Even, DriveRows::Kept}) {
      const Driven run = driven(scan, [&](Drive& drive) {
        drive.setRows(rows);
        drive.setToolRadius(radius);
        drive.setScallopHeight(height);
        drive.setStepOver(2.0 * std::sqrt((2.0 * radius - height) * height));
        drive.setPlaneDirection(direction);
        drive.setPointSpacing(0.5);
      });
      const auto [p99, p999] = heightsLeftBy(*land, ballPath(scan, run.passes), size);
      std::printf("  %s: %zu rows, %.4f to %.4f mm, p99 %.4f h, p99.9 %.4f h\n", rows == DriveRows::Even ? "even" : "kept", run.report.rows,
                  run.report.smallest_step, run.report.step_over, p99, p999);
      EXPECT_TRUE(run.report.warnings.empty());
      if (rows == DriveRows::Even) {
        even = run.report.rows;
        EXPECT_GT(p999, 1.1);
        continue;
      }
      EXPECT_LE(p999, 1.02);
      EXPECT_GT(p999, 0.9);
      EXPECT_LE(static_cast<double>(run.report.rows), 1.12 * static_cast<double>(even));
      EXPECT_LT(run.report.smallest_step, run.report.step_over);
      EXPECT_EQ(run.report.held_share, 0.0);
    }
  }
}

TEST(KeptRows, AreHardlyMoreUnderNoise)
{
  const SurfacePtr land = landform();
  for (const double sigma : {0.0, 0.005, 0.02}) {
    Sampled scan = sampleUniform(*land, 60000, 4);
    addNoise(scan, sigma, 5);
    const Driven run = driven(scan.points, [&](Drive& drive) {
      drive.setRows(DriveRows::Kept);
      drive.setToolRadius(radius);
      drive.setScallopHeight(height);
    });
    std::printf("  noise %.3f mm: %zu rows, %.4f to %.4f mm\n", sigma, run.report.rows, run.report.smallest_step, run.report.step_over);
    EXPECT_LE(static_cast<double>(run.report.rows), 1.12 * 159.0);
    EXPECT_TRUE(run.report.warnings.empty());
  }
}

/** A wall along the planes would need endless rows; planes across it are not affected. */
TEST(KeptRows, AreHeldOnWallsAlongThePlanesAndSaySo)
{
  std::vector<Vector3d> scan;
  Random random(3);
  for (int i = 0; i < 30000; ++i) { // 8 mm high, up to 85 degrees steep
    const double x = random.uniform(-15.0, 15.0), y = random.uniform(-20.0, 20.0);
    scan.emplace_back(x, y, 4.0 * std::tanh(3.0 * y));
  }
  const double step = 2.0 * std::sqrt((2.0 * 0.5 - height) * height);
  for (const double direction : {0.0, 90.0}) {
    const Driven run = driven(scan, [&](Drive& drive) {
      drive.setRows(DriveRows::Kept);
      drive.setToolRadius(0.5);
      drive.setScallopHeight(height);
      drive.setPlaneDirection(direction);
    });
    if (direction > 0.0) {
      EXPECT_LE(run.report.rows, static_cast<std::size_t>(1.1 * 30.0 / step));
      EXPECT_EQ(run.report.held_share, 0.0);
      EXPECT_TRUE(run.report.warnings.empty());
      continue;
    }
    EXPECT_LE(run.report.rows, static_cast<std::size_t>(1.5 * 40.0 / step));
    EXPECT_GT(run.report.held_share, 0.01);
    EXPECT_GE(run.report.smallest_step, 0.2 * step);
    ASSERT_EQ(run.report.warnings.size(), 1U);
    EXPECT_NE(run.report.warnings[0].text().find("turn the planes"), std::string::npos) << run.report.warnings[0];
  }
}

} // namespace kept_rows_test
