// SPDX-License-Identifier: BSD-3-Clause
// Spirals over scans from one side, closed by the ball: judged by every point of the scan as it was.
#include <pcl_spiral/planning/spiral_planner.h>

#include "support/range_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ball_closing_plans_test {

namespace {

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Eigen::Vector3d;
using Planner = SpiralPlanner<pcl::PointXYZ>;

constexpr double radius = 5.0, noise = 0.05; // mm

Cloud::Ptr
view(test::FoldedPart kind, unsigned int seed)
{
  return test::rangeView(test::foldedPart(kind, seed), noise, seed);
}

void
prepare(const Cloud::ConstPtr& scan, Planner& planner)
{
  planner.setInputCloud(scan);
  planner.setToolRadius(radius);
  planner.setScallopHeight(0.2);
  planner.setViewPoint({0, 0, 500});
  planner.setBallClosing(true);
  planner.setQuiet(true);
}

/** How deep the points of \p scan are in the ball of \p path and in the shank above it, also on the moves: by all points near it. */
struct Depths {
  double ball = 0.0, shank = 0.0;
};
Depths
depthsOf(const pcl::PointCloud<ToolpathPoint>& path, const Cloud& scan)
{
  Depths deepest;
  std::vector<Vector3d> points;
  for (const pcl::PointXYZ& p : scan)
    if (std::isfinite(p.x))
      points.push_back(p.getVector3fMap().cast<double>());
  std::sort(points.begin(), points.end(), [](const Vector3d& a, const Vector3d& b) { return a.x() < b.x(); });
  const auto look = [&](const Vector3d& centre, const Vector3d& axis) {
    auto at =
        std::lower_bound(points.begin(), points.end(), centre.x() - 1.2 * radius, [](const Vector3d& p, double x) { return p.x() < x; });
    for (; at != points.end() && at->x() < centre.x() + 1.2 * radius; ++at) {
      const Vector3d off = *at - centre;
      const double up = off.dot(axis);
      deepest.ball = std::max(deepest.ball, radius - off.norm());
      if (up > 0.0 && up < 10.0 * radius)
        deepest.shank = std::max(deepest.shank, radius - (off - up * axis).norm());
    }
  };
  for (std::size_t i = 0; i + 1 < path.size(); i += 31) {
    const auto centre = [&path](std::size_t k) -> Vector3d {
      return path[k].getVector3fMap().cast<double>() + radius * path[k].getNormalVector3fMap().cast<double>();
    };
    const Vector3d axis(path[i].axis_x, path[i].axis_y, path[i].axis_z);
    look(centre(i), axis);
    look(0.5 * (centre(i) + centre(i + 1)), axis);
  }
  return deepest;
}

} // namespace

TEST(BallClosingPlans, AreClearOfEveryPoint)
{
  for (const auto& [kind, seed] : {std::pair(test::FoldedPart::Bust, 1u), {test::FoldedPart::Hand, 2u}}) {
    const Cloud::Ptr scan = view(kind, seed);
    Planner planner;
    prepare(scan, planner);
    pcl::PointCloud<ToolpathPoint> path;
    planner.compute(path);
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    const double allowed = planner.getChordError() + 5.0 * noise;
    const Depths depths = depthsOf(path, *scan);
    EXPECT_LT(depths.ball, allowed);
    EXPECT_LT(depths.shank, allowed);
    for (std::size_t i = 1; i < path.size(); i += 100)
      EXPECT_EQ(path[i].axis_z, path[0].axis_z); // one axis, so that a machine with three axes can cut it
    EXPECT_TRUE(std::any_of(planner.getReport().warnings.begin(), planner.getReport().warnings.end(),
                            [](const Diagnostic& w) { return w.text().find("lie under overhangs or in folds") != std::string::npos; }));
  }
}

TEST(BallClosingPlans, FalseEchoesThatAreFilteredDoNotLift)
{
  const Cloud::Ptr scan = view(test::FoldedPart::Hand, 2), dirty = pcl::make_shared<Cloud>(*scan);
  const Eigen::Vector3f echo(0.0f, -20.0f, 60.0f); // 45 mm over the back of the hand
  dirty->points[0].getVector3fMap() = echo;
  const auto highest = [&](int neighbours) {
    Planner planner;
    prepare(dirty, planner);
    planner.setScallopHeight(0.4);
    if (neighbours > 0)
      planner.setOutlierRemoval(neighbours, 3.0);
    pcl::PointCloud<ToolpathPoint> path;
    planner.compute(path);
    EXPECT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    double high = 0.0, nearest = 1e9;
    for (const ToolpathPoint& p : path) {
      high = std::max(high, static_cast<double>(p.z));
      nearest = std::min<double>(nearest, (p.getVector3fMap() + static_cast<float>(radius) * p.getNormalVector3fMap() - echo).norm());
    }
    if (neighbours == 0)
      EXPECT_GT(nearest, radius - 0.3);
    return high;
  };
  EXPECT_LT(highest(16), 40.0);
  EXPECT_GT(highest(0), 45.0); // it rides over the echo
}

TEST(BallClosingPlans, TheAxisIsTheDirection)
{
  const Cloud::Ptr scan = view(test::FoldedPart::Hand, 2);
  Planner planner;
  prepare(scan, planner);
  planner.setScallopHeight(0.4);
  planner.setFixedAxis({0, 0.1, 1});
  pcl::PointCloud<ToolpathPoint> path;
  planner.compute(path);
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  const Vector3d axis = Vector3d(0, 0.1, 1).normalized();
  EXPECT_NEAR(path.front().axis_y, axis.y(), 1e-6);
  EXPECT_NEAR(path.front().axis_z, axis.z(), 1e-6);
  EXPECT_LT(depthsOf(path, *scan).shank, planner.getChordError() + 5.0 * noise);
}

TEST(BallClosingPlans, RefuseWhatDoesNotFit)
{
  const auto says = [](Planner& planner, const char* words) {
    planner.compute();
    EXPECT_FALSE(planner.getStatus().ok());
    EXPECT_TRUE(planner.getPlan().path->empty());
    EXPECT_NE(planner.getStatus().message().find(words), std::string::npos) << planner.getStatus().message();
  };
  const Cloud::Ptr scan = view(test::FoldedPart::Hand, 2);
  Planner flipped, some, coarse, thinned;
  prepare(scan, thinned);
  thinned.setThinning(1.0);
  says(thinned, "setThinning");
  prepare(scan, flipped);
  flipped.setFlipNormals(true);
  says(flipped, "setFlipNormals");
  prepare(scan, some);
  some.setIndices(pcl::make_shared<pcl::Indices>(100, 1));
  says(some, "setIndices");
  prepare(scan, coarse);
  coarse.setToolRadius(0.2);
  says(coarse, "not larger than the point spacing");
}

} // namespace ball_closing_plans_test
