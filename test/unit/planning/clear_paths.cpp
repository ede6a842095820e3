// SPDX-License-Identifier: BSD-3-Clause
// A change is a remedy only if its path is clear of the points that the fitted surface misses; single echoes are no such points.
#include "planning/changes_tried.h"

#include "support/sampling.h"
#include "support/spiral_jobs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace clear_paths_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

constexpr double spacing = 0.8, edge = 9.0; // mm

/** A disc of radius 20 with a round plateau in the middle, \p high above it, whose upper edge a fit cuts off. */
ScanPtr
plateau(double high)
{
  Random random(3);
  const ScanPtr scan(new pcl::PointCloud<pcl::PointXYZ>);
  const int half = static_cast<int>(20.0 / spacing);
  for (int i = -half; i <= half; ++i)
    for (int k = -half; k <= half; ++k) {
      const double x = spacing * (i + random.uniform(-0.3, 0.3)), y = spacing * (k + random.uniform(-0.3, 0.3)), r = std::hypot(x, y);
      if (r < 20.0)
        scan->emplace_back(static_cast<float>(x), static_cast<float>(y),
                           static_cast<float>((r < edge ? high : 0.0) + 0.01 * random.normal()));
    }
  return scan;
}

void
plan(const ScanPtr& scan, Spiral& planner)
{
  planner.setInputCloud(scan);
  planner.setToolRadius(4.0);
  planner.setScallopHeight(0.1);
  planner.setQuiet(true);
  planner.compute();
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
}

TEST(ClearPaths, OneThatCutsTheEdgeOfAStepIsNotClear)
{
  for (const double spacings : {1.0, 1.2, 1.5}) {
    Spiral planner;
    plan(plateau(spacings * spacing), planner);
    const MissedPoints& missed = planner.getReport().missed;
    EXPECT_GT(missed.count, 10U) << spacings;
    EXPECT_NEAR(missed.place.head<2>().norm(), edge, spacing) << spacings;
    EXPECT_NEAR(missed.noise, 0.01, 0.005) << "the step is no noise: " << spacings;
    EXPECT_FALSE(isClear(planner.getPlan())) << spacings;
  }
}

TEST(ClearPaths, EchoesDoNotForbidAPath)
{
  const ScanPtr scan = plateau(0.0);
  for (int k = 0; k < 5; ++k) // left out of the surface, some of them so low that they count as missed
    scan->emplace_back(-12.0F + 6.0F * static_cast<float>(k), 0.1F, 0.3F + 0.4F * static_cast<float>(k));
  Spiral planner;
  plan(scan, planner);
  EXPECT_GT(planner.getReport().missed.count, 0U);
  EXPECT_TRUE(isClear(planner.getPlan()));
}

/** A wave \p length long and 3 mm from top to bottom, seen at points \p apart. */
ScanPtr
waveScan(double length, double apart, double noise)
{
  Random random(5);
  const ScanPtr scan(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 16; ++i)
    for (int k = 0; k < 16; ++k) {
      const double x = apart * (i + random.uniform(-0.1, 0.1)), y = apart * (k + random.uniform(-0.1, 0.1));
      scan->emplace_back(static_cast<float>(x), static_cast<float>(y),
                         static_cast<float>(1.5 * std::sin(2.0 * M_PI * x / length) + noise * random.normal()));
    }
  return scan;
}

/** The deepest point of \p scan in a ball of radius \p radius along \p path. */
double
deepestOf(const pcl::PointCloud<ToolpathPoint>& path, double radius, const pcl::PointCloud<pcl::PointXYZ>& scan)
{
  double depth = 0.0;
  for (const ToolpathPoint& p : path) {
    const Eigen::Vector3f centre = p.getVector3fMap() + static_cast<float>(radius) * p.getNormalVector3fMap();
    for (const pcl::PointXYZ& q : scan)
      depth = std::max(depth, radius - static_cast<double>((q.getVector3fMap() - centre).norm()));
  }
  return depth;
}

/** What 32 points far apart leave of a fit is shape: the noise that was added decides. */
TEST(ClearPaths, OfACoarseScanTheShapeIsNoNoise)
{
  constexpr double noise = 0.02, radius = 4.0;
  bool some = false, others = false;
  for (const double length : {24.0, 32.0, 40.0, 200.0}) {
    const ScanPtr scan = waveScan(length, 4.0, noise);
    Spiral planner;
    planner.setInputCloud(scan);
    planner.setToolRadius(radius);
    planner.setScallopHeight(0.2);
    planner.setQuiet(true);
    planner.compute();
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    const double depth = deepestOf(*planner.getPlan().path, radius, *scan);
    if (depth > 0.25) // ten standard deviations and more
      EXPECT_FALSE(isClear(planner.getPlan())) << length << " " << depth;
    if (depth < 0.08)
      EXPECT_TRUE(isClear(planner.getPlan())) << length << " " << depth;
    some = some || depth > 0.25;
    others = others || depth < 0.08;
  }
  EXPECT_TRUE(some && others);
}

} // namespace clear_paths_test
