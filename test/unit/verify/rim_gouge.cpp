// SPDX-License-Identifier: BSD-3-Clause
// Gouges at the rim: as deep as the points of the scan are in the ball, not as far as the ray under the rim stays in what it sweeps.
#include <pcl_spiral/verify/material_removal.h>

#include "support/move_tree.h"
#include "support/passes.h"
#include "support/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rim_gouge_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double R = 6.0, half = 20.0;

/** Sound rows over the plane, then a pass through \p centres, its contacts below in the direction \p normal. */
pcl::PointCloud<ToolpathPoint>::Ptr
rowsAnd(const AnalyticSurface& surface, const Polyline& centres, const Eigen::Vector3d& normal)
{
  std::vector<double> us;
  for (int i = -13; i <= 13; ++i)
    us.push_back(1.5 * i);
  CheckedPath path = straightPasses(surface, us, half, 2.0);
  for (const Eigen::Vector3d& centre : centres) {
    path.contacts.push_back(centre - R * normal);
    path.normals.push_back(normal);
    path.turns.push_back(99.0);
  }
  return toolpath(path);
}

pcl_spiral::RemovalReport
figuresOf(const pcl::PointCloud<pcl::PointXYZ>::Ptr& scan, const pcl::PointCloud<ToolpathPoint>::Ptr& path, std::size_t passes,
          pcl::PointCloud<pcl::PointXYZI>& stock)
{
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(scan);
  removal.setInputToolpath(path, {path->size() - passes});
  removal.setToolRadius(R);
  removal.setScallopHeight(0.05);
  removal.compute(stock);
  EXPECT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  return removal.getReport();
}

/** How deep the deepest point of the scan is in the ball that moves through \p centres. */
double
deepest(const pcl::PointCloud<pcl::PointXYZ>& scan, const Polyline& centres)
{
  double most = 0.0;
  const MoveTree way(centres);
  for (const pcl::PointXYZ& point : scan)
    most = std::max(most, R - way.nearest(point.getVector3fMap().cast<double>()).first);
  return most;
}

} // namespace

TEST(RimGouge, BesideACornerIsAsDeepAsTheCornerIsInTheBall)
{
  const SurfacePtr surface = flat(Region({rectangle(2.0 * half, 2.0 * half)}));
  for (const std::size_t points : {1500u, 12000u}) {
    const auto scan = toCloud(sampleUniform(*surface, points, 3).points);
    scan->emplace_back(half, half, 0.0f);
    const double beside = (R - 0.34) / std::sqrt(2.0);
    Polyline centres; // down, past the corner, and 10 mm below the plane
    for (double z = R; z >= -10.0; z -= 0.5)
      centres.emplace_back(half + beside, half + beside, z);
    pcl::PointCloud<pcl::PointXYZI> stock;
    const auto path = rowsAnd(*surface, centres, Eigen::Vector3d(1.0, 1.0, 0.0).normalized());
    const auto f = figuresOf(scan, path, centres.size(), stock);
    const double expected = deepest(*scan, centres);
    EXPECT_NEAR(expected, 0.34, 1e-3);
    EXPECT_NEAR(f.gouge.value, expected, 0.01) << points << " at " << f.gouge.position.transpose();
    EXPECT_LT(f.rim_gouge.value, expected + 0.1) << points << " at " << f.rim_gouge.position.transpose();
    float lowest = 0.0f;
    for (const pcl::PointXYZI& point : stock)
      lowest = std::min(lowest, point.intensity);
    EXPECT_NEAR(-lowest, f.gouge.value, 0.01);
  }
}

TEST(RimGouge, AlongARimIsAsDeepAsTheRimIsInTheBall)
{
  const SurfacePtr surface = flat(Region({rectangle(2.0 * half, 2.0 * half)}));
  const auto scan = toCloud(sampleUniform(*surface, 12000, 3).points);
  for (const double height : {-4.0, -1.0, 2.0, 4.0}) {
    Polyline centres; // along the rim, the ball 0.5 mm into it
    const double beside = std::sqrt((R - 0.5) * (R - 0.5) - height * height);
    for (double y = -15.0; y <= 15.0; y += 1.0)
      centres.emplace_back(half + beside, y, height);
    pcl::PointCloud<pcl::PointXYZI> stock;
    const Eigen::Vector3d normal = Eigen::Vector3d(beside, 0.0, height).normalized();
    const auto f = figuresOf(scan, rowsAnd(*surface, centres, normal), centres.size(), stock);
    const double expected = deepest(*scan, centres);
    EXPECT_GT(std::max(f.gouge.value, f.rim_gouge.value), expected - 0.01) << height;
    EXPECT_LT(f.gouge.value, 0.5 + 0.05) << height << " at " << f.gouge.position.transpose();
    EXPECT_LT(f.rim_gouge.value, 0.5 + 0.15) << height << " at " << f.rim_gouge.position.transpose();
  }
}

TEST(RimGouge, OverTheRimItKeepsItsFullDepth)
{
  const SurfacePtr surface = flat(Region({rectangle(2.0 * half, 2.0 * half)}));
  const auto scan = toCloud(sampleUniform(*surface, 12000, 3).points);
  Polyline centres; // across the rim, 1.5 mm too deep
  for (double x = 0.0; x <= half + 3.0; x += 1.0)
    centres.emplace_back(x, 3.0, R - 1.5);
  pcl::PointCloud<pcl::PointXYZI> stock;
  const auto f = figuresOf(scan, rowsAnd(*surface, centres, Eigen::Vector3d::UnitZ()), centres.size(), stock);
  EXPECT_NEAR(f.gouge.value, 1.5, 0.01);
}

} // namespace rim_gouge_test
