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

constexpr double ball_radius = 5.0, noise = 0.05; // mm

Cloud::Ptr
view(test::FoldedPart kind, unsigned int seed)
{
  return test::rangeView(test::foldedPart(kind, seed), noise, seed);
}

void
prepare(const Cloud::ConstPtr& scan, Planner& planner)
{
  planner.setInputCloud(scan);
  planner.setToolRadius(ball_radius);
  planner.setScallopHeight(0.2);
  planner.setViewPoint({0, 0, 500});
  planner.setBallClosing(true);
  planner.setQuiet(true);
}

/** A block of 30 by 30 mm, 15 mm high, on a table of 70 by 70 mm: a camera above sees no wall. */
Cloud::Ptr
blockOnTable()
{
  const auto scan = pcl::make_shared<Cloud>();
  for (float x = -35.0f; x <= 35.0f; x += 0.8f)
    for (float y = -35.0f; y <= 35.0f; y += 0.8f)
      scan->push_back({x, y, std::abs(x) < 15.0f && std::abs(y) < 15.0f ? 15.0f : 0.0f});
  return scan;
}

/** How deep the points of \p scan are in the ball of \p path and in the shank above it, also on the moves: by all points near it. */
struct Depths {
  double ball = 0.0, shank = 0.0;
};
Depths
depthsOf(const pcl::PointCloud<ToolpathPoint>& path, const Cloud& scan, double radius = ball_radius)
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
  for (std::size_t i = 0; i + 1 < path.size(); i += 3) {
    const auto centre = [&path, radius](std::size_t k) -> Vector3d {
      return path[k].getVector3fMap().cast<double>() + radius * path[k].getNormalVector3fMap().cast<double>();
    };
    const Vector3d axis(path[i].axis_x, path[i].axis_y, path[i].axis_z);
    look(centre(i), axis);
    look(0.5 * (centre(i) + centre(i + 1)), axis);
  }
  return deepest;
}

/** The chord error alone: noise is no reason to cut a point. And rounding of the path to single precision. */
double
allowedDepth(const Planner& planner)
{
  return planner.getChordError() + 1e-4;
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
    const Depths depths = depthsOf(path, *scan);
    EXPECT_LT(depths.ball, allowedDepth(planner));
    EXPECT_LT(depths.shank, allowedDepth(planner));
    for (std::size_t i = 1; i < path.size(); i += 100) { // one axis, so that a machine with three axes can cut it
      EXPECT_EQ(path[i].axis_x, path[0].axis_x);
      EXPECT_EQ(path[i].axis_y, path[0].axis_y);
      EXPECT_EQ(path[i].axis_z, path[0].axis_z);
    }
    EXPECT_TRUE(std::any_of(planner.getReport().warnings.begin(), planner.getReport().warnings.end(),
                            [](const Diagnostic& w) { return w.text().find("lie under overhangs or in folds") != std::string::npos; }));
  }
}

TEST(BallClosingPlans, FalseEchoesThatAreFilteredDoNotLift)
{
  const Cloud::Ptr dirty = blockOnTable();
  const Eigen::Vector3f echo(0.0f, 0.0f, 25.0f); // 10 mm over the block
  dirty->push_back({echo.x(), echo.y(), echo.z()});
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
      nearest = std::min<double>(nearest, (p.getVector3fMap() + static_cast<float>(ball_radius) * p.getNormalVector3fMap() - echo).norm());
    }
    if (neighbours == 0)
      EXPECT_GT(nearest, ball_radius - 0.3);
    return high;
  };
  EXPECT_LT(highest(16), 16.0); // the fit swings over at the edges of the block
  EXPECT_GT(highest(0), 24.5);  // it rides over the echo
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
  EXPECT_LT(depthsOf(path, *scan).shank, allowedDepth(planner));
}

TEST(BallClosingPlans, JoinedPartsAreNamedAndOneCanBeChosen)
{
  const Cloud::Ptr scan = blockOnTable();
  struct Heights {
    float lowest, highest;
  };
  const auto heights = [&](Planner& planner) {
    prepare(scan, planner);
    pcl::PointCloud<ToolpathPoint> path;
    planner.compute(path);
    EXPECT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    const Depths depths = depthsOf(path, *scan);
    EXPECT_LT(std::max(depths.ball, depths.shank), allowedDepth(planner));
    Heights found{15.0f, 0.0f};
    for (const ToolpathPoint& p : path)
      found = {std::min(found.lowest, p.z), std::max(found.highest, p.z)};
    return found;
  };
  const auto names = [](const Planner& planner) {
    const auto& all = planner.getReport().warnings;
    return std::any_of(all.begin(), all.end(), [](const Diagnostic& w) {
      const std::vector<Vector3d> places = w.places();
      return w.id().find("those beside each other are one") != std::string::npos && places.size() == 2 &&
             std::abs(places[0].z() - places[1].z()) > 14.0;
    });
  };
  Planner both, block, top, table;
  const Heights of_both = heights(both);
  EXPECT_LT(of_both.lowest, 0.1f);
  EXPECT_GT(of_both.highest, 14.9f);
  EXPECT_TRUE(names(both));
  block.setPartAt({3, 4, 15});
  EXPECT_GT(heights(block).lowest, 14.9f);
  EXPECT_FALSE(names(block));
  const auto on_top = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < scan->size(); ++i)
    if ((*scan)[i].z > 10.0f)
      on_top->push_back(static_cast<pcl::index_t>(i));
  top.setIndices(on_top);
  EXPECT_GT(heights(top).lowest, 14.9f);
  table.setLargestPart(true);
  EXPECT_LT(heights(table).highest, 1.5f); // it ends where the ball would touch the block
}

/** A program gives a place as a region. */
TEST(BallClosingPlans, AnOnlyRegionChoosesAsThePlaceDoes)
{
  const Cloud::Ptr scan = blockOnTable();
  const auto pathOf = [&scan](Planner& planner) {
    prepare(scan, planner);
    pcl::PointCloud<ToolpathPoint> path;
    planner.compute(path);
    EXPECT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    return path;
  };
  Planner by_place, by_region, of_all, of_all_in_one;
  by_place.setPartAt({3, 4, 15});
  by_region.addRegion({{}, Vector3d(3, 4, 15), "block"});
  of_all_in_one.addRegion({});
  const auto same = [](const pcl::PointCloud<ToolpathPoint>& a, const pcl::PointCloud<ToolpathPoint>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const ToolpathPoint& p, const ToolpathPoint& q) {
             return p.getVector3fMap() == q.getVector3fMap();
           });
  };
  EXPECT_TRUE(same(pathOf(by_place), pathOf(by_region)));
  EXPECT_TRUE(same(pathOf(of_all), pathOf(of_all_in_one)));
  EXPECT_EQ(by_region.getPlan().region, "block");
  EXPECT_EQ(of_all_in_one.getReport().warnings.size(), of_all.getReport().warnings.size()); // that parts beside each other are joined
}

TEST(BallClosingPlans, ARefusalNamesItIfItWouldGiveAPath)
{
  const Cloud::Ptr scan = blockOnTable(); // two separate parts
  const auto remedies = [&](bool side_known, double radius) {
    Planner planner;
    planner.setInputCloud(scan);
    planner.setToolRadius(radius);
    planner.setScallopHeight(0.04 * radius);
    if (side_known)
      planner.setViewPoint({0, 0, 500});
    planner.setQuiet(true);
    planner.compute();
    EXPECT_FALSE(planner.getStatus().ok());
    return planner.getStatus().diagnostic().settings();
  };
  const auto has = [](const std::vector<std::string>& settings) {
    return std::find(settings.begin(), settings.end(), "setBallClosing(true)") != settings.end();
  };
  EXPECT_TRUE(has(remedies(true, ball_radius)));
  EXPECT_FALSE(has(remedies(false, ball_radius))); // from which side?
  EXPECT_FALSE(has(remedies(true, 0.7)));          // that ball falls between the points: there is no path, either
}

TEST(BallClosingPlans, CoarseScansAreNotCut)
{
  // One point in 36: the fit of the closed surface is off by more than the noise of the scan, which must not count as noise.
  const Cloud::Ptr fine = test::rangeView(test::foldedPart(test::FoldedPart::Bust, 1), 0.0, 1), coarse = pcl::make_shared<Cloud>();
  for (std::size_t row = 0; row < fine->height; row += 6)
    for (std::size_t column = 0; column < fine->width; column += 6)
      coarse->push_back(fine->at(column, row));
  Planner planner;
  prepare(coarse, planner);
  planner.setToolRadius(9.0);
  pcl::PointCloud<ToolpathPoint> path;
  planner.compute(path);
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  EXPECT_LT(depthsOf(path, *coarse, 9.0).ball, allowedDepth(planner));
  EXPECT_EQ(planner.getReport().input_points, coarse->size()); // not the points of the closed surface
  EXPECT_EQ(planner.getReport().side.vote, SideVote::ToolAxis);
}

TEST(BallClosingPlans, PointsThatTheFilterTakesForEchoesAreReported)
{
  const Cloud::Ptr scan = blockOnTable();
  scan->push_back({0.0f, 0.0f, 20.0f}); // 5 mm over the block
  Planner planner;
  prepare(scan, planner);
  planner.setOutlierRemoval(8, 4.0);
  planner.compute();
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  const auto& all = planner.getReport().warnings;
  const auto told =
      std::find_if(all.begin(), all.end(), [](const Diagnostic& w) { return w.id().find("false echoes") != std::string::npos; });
  ASSERT_NE(told, all.end());
  ASSERT_EQ(told->numbers().size(), 2u) << *told;
  EXPECT_EQ(told->numbers()[0], planner.getReport().outlier_points);
  EXPECT_GT(told->numbers()[1], 0.8 * ball_radius); // the ball over the block has the echo in its middle
  EXPECT_LE(told->numbers()[1], ball_radius);
  EXPECT_LT((told->places().front() - Vector3d(0, 0, 15)).norm(), 2.5);
}

TEST(BallClosingPlans, PointsFarOutsideOfTheCropDoNotCount)
{
  const Cloud::Ptr scan = blockOnTable();
  scan->push_back({1e5f, 1e5f, 0.0f}); // a grid to there would have too many nodes
  Planner planner;
  prepare(scan, planner);
  planner.clearViewPoint();
  planner.setFixedAxis({0, 0, 1});
  planner.compute();
  EXPECT_FALSE(planner.getStatus().ok());
  planner.setCropBox(Eigen::AlignedBox3d(Vector3d(-12, -12, -1), Vector3d(12, 12, 16)));
  planner.compute();
  EXPECT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
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
  Planner flipped, coarse, thinned;
  prepare(scan, thinned);
  thinned.setThinning(1.0);
  says(thinned, "setThinning");
  prepare(scan, flipped);
  flipped.setFlipNormals(true);
  says(flipped, "setFlipNormals");
  Planner ridden, strict;
  prepare(scan, ridden);
  ridden.setClusterHandling(ClusterHandling::Ride);
  says(ridden, "setClusterHandling");
  prepare(scan, strict);
  strict.setTightHandling(TightHandling::Refuse);
  says(strict, "setTightHandling");
  prepare(scan, coarse);
  coarse.setToolRadius(0.2);
  says(coarse, "not larger than the point spacing");
}

} // namespace ball_closing_plans_test
