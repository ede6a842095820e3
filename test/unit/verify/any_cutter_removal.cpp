// SPDX-License-Identifier: BSD-3-Clause
// Stock and gouges of cutters that are no ball: exact ridges on a plane, and the cutter tried place by place over a dome.
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/verify/material_removal.h>

#include "support/cutters.h"
#include "support/passes.h"
#include "support/reference.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace any_cutter_removal_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double h = 0.02;

/** A path of a cutter with tips and axes. */
struct CutterWay {
  CheckedPath contacts;
  std::vector<Eigen::Vector3d> axes;
  Polyline tips;
};

/** The cutter at the contacts, its axis leaning forward by \p lean degrees from the normal, in the direction of the passes. */
CutterWay
wayOf(const CheckedPath& contacts, const CutterShape& cutter, double lean)
{
  CutterWay way{contacts, {}, {}};
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Eigen::Vector3d& n = contacts.normals[i];
    const Eigen::Vector3d sideways = n.cross(Eigen::Vector3d::UnitY()).normalized();
    way.axes.push_back(Eigen::AngleAxisd(lean * degree, sideways) * n);
    way.tips.push_back(CutterProfile(cutter).locate(contacts.contacts[i], n, way.axes[i]).tip);
  }
  return way;
}

pcl_spiral::RemovalReport
measured(const AnalyticSurface& surface, const CutterWay& way, const CutterShape& cutter, std::size_t points,
         pcl::PointCloud<pcl::PointXYZI>& stock, int threads = 0)
{
  const auto path = toolpath(way.contacts);
  for (std::size_t i = 0; i < path->size(); ++i)
    (*path)[i].getAxisVector3fMap() = way.axes[i].cast<float>();
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(toCloud(sampleUniform(surface, points, 1).points));
  removal.setInputToolpath(path);
  removal.setInputTips(way.tips);
  removal.setCutter(cutter);
  removal.setScallopHeight(h);
  removal.setChordError(0.0);
  removal.setNumberOfThreads(threads);
  removal.compute(stock);
  EXPECT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  return removal.getReport();
}

std::vector<CutterShape>
cutters()
{
  return {CutterShape::bullNose(6.0, 1.5), CutterShape::flatEnd(5.0), CutterShape::taperedBall(5.0, 15.0, 10.0),
          CutterShape::taperedBullNose(6.0, 1.0, 12.0, 8.0), CutterShape::ball(5.0, 8.0)};
}

/** Depth of \p x in the cutter where it is deepest on move \p i: the depth rises and then falls, so thirds are left out. */
double
depthOnMove(const CutterWay& way, const CutterShape& cutter, std::size_t i, const Eigen::Vector3d& x)
{
  const CutterProfile profile(cutter);
  const auto depth = [&](double f) {
    return depthOf(x, profile, onTheWay({way.tips[i], way.axes[i]}, {way.tips[i + 1], way.axes[i + 1]}, f));
  };
  double low = 0.0, high = 1.0;
  while (high - low > 1e-5) {
    const double third = (high - low) / 3.0;
    if (depth(low + third) < depth(high - third))
      low += third;
    else
      high -= third;
  }
  return std::max({depth(0.0), depth(1.0), depth(0.5 * (low + high))});
}

SurfacePtr
dome()
{
  return ball(80.0, Region({circle({0, 0}, 14.0)}));
}

std::vector<double>
columns(double first, double step, int count)
{
  std::vector<double> us;
  for (int i = 0; i < count; ++i)
    us.push_back(first + i * step);
  return us;
}

} // namespace

TEST(AnyCutterRemoval, RidgesOnThePlaneHaveTheHeightAskedFor)
{
  const SurfacePtr surface = flat(Region({rectangle(50.0, 50.0)}));
  for (const CutterShape& cutter : cutters()) {
    const double step = stepForScallop(CutterProfile(cutter), h).value();
    if (cutter.corner_radius == 0.0)
      continue; // its edges meet, and leave no ridge
    const int half = static_cast<int>(std::ceil(25.0 / step));
    pcl::PointCloud<pcl::PointXYZI> stock;
    const auto passes = straightPasses(*surface, columns(-half * step, step, 2 * half + 1), 27.0, 2.0);
    const auto f = measured(*surface, wayOf(passes, cutter, 0.0), cutter, 8000, stock);
    EXPECT_NEAR(f.scallop.max.value / h, 1.0, 0.005) << cutter.radius << ' ' << cutter.corner_radius;
    EXPECT_NEAR(f.scallop.p50 / h, 1.0, 0.005);
    EXPECT_LT(f.gouge.value, 1e-5);
    EXPECT_EQ(f.stock.uncut, 0u);
    EXPECT_LE(f.efficiency, 1.0);
    EXPECT_GT(f.efficiency, 0.5);
  }
}

TEST(AnyCutterRemoval, StockIsWhatTheCutterLeavesOnItsMoves)
{
  const SurfacePtr surface = dome();
  for (const CutterShape& cutter : cutters()) {
    const CutterWay way = wayOf(straightPasses(*surface, {-3.0, -1.0, 1.0, 3.0}, 6.0, 1.5), cutter, 12.0);
    pcl::PointCloud<pcl::PointXYZI> stock;
    measured(*surface, way, cutter, 4000, stock);
    int compared = 0;
    for (std::size_t i = 0; i < stock.size(); i += 7) {
      const Eigen::Vector3d x = surface->closest(stock[i].getVector3fMap().cast<double>()), n = surface->normal(x);
      if (std::abs(x.x()) > 3.0 || std::abs(x.y()) > 5.0 || stock[i].intensity > 19.0 * h)
        continue;
      const auto deepest = [&](double t) {
        double most = -1e300;
        for (std::size_t move = 0; move + 1 < way.tips.size(); ++move)
          most = std::max(most, depthOnMove(way, cutter, move, x + t * n));
        return most;
      };
      EXPECT_LT(deepest(stock[i].intensity - 0.002), 1e-4) << cutter.radius << ' ' << cutter.corner_radius << ' ' << x.transpose();
      EXPECT_GT(deepest(stock[i].intensity + 0.002), -1e-4) << cutter.radius << ' ' << cutter.corner_radius << ' ' << x.transpose();
      ++compared;
    }
    EXPECT_GT(compared, 20);
  }
}

TEST(AnyCutterRemoval, APlantedGougeHasItsDepth)
{
  const SurfacePtr surface = dome();
  for (const CutterShape& cutter : cutters())
    for (const double deep : {0.02, 0.3}) {
      CutterWay way = wayOf(straightPasses(*surface, columns(-13.0, 1.0, 27), 14.0, 0.7), cutter, 12.0);
      const std::size_t at = nearestContact(way.contacts, surface->lift({2.0, 3.0}));
      way.tips[at] -= deep * way.contacts.normals[at];
      pcl::PointCloud<pcl::PointXYZI> stock;
      const auto f = measured(*surface, way, cutter, 3000, stock);
      double most = 0.0; // of a point of the surface in the cutter on the moves to and from the place
      for (double u = -1.0; u <= 1.0; u += 0.05)
        for (double v = -1.0; v <= 1.0; v += 0.05) {
          const Eigen::Vector2d chart = surface->chart(way.contacts.contacts[at]) + Eigen::Vector2d(u, v);
          for (const std::size_t move : {at - 1, at})
            most = std::max(most, depthOnMove(way, cutter, move, surface->lift(chart)));
        }
      EXPECT_GT(most, 0.5 * deep);
      EXPECT_GT(f.gouge.value, most - 0.02 * deep - 5e-4) << cutter.radius << ' ' << cutter.corner_radius << ' ' << deep;
      EXPECT_LT(f.gouge.value, deep * 1.02 + 5e-4) << cutter.radius << ' ' << cutter.corner_radius << ' ' << deep;
      EXPECT_LT((f.gouge.position - way.contacts.contacts[at]).norm(), 1.5);
      EXPECT_LE(std::max(f.gouge.index, at) - std::min(f.gouge.index, at), 1u);
    }
}

TEST(AnyCutterRemoval, TipsFollowFromTheContactsWhereNoneAreGiven)
{
  const SurfacePtr surface = dome();
  const CutterShape cutter = CutterShape::bullNose(6.0, 1.5);
  CutterWay way = wayOf(straightPasses(*surface, columns(-13.0, 1.0, 27), 14.0, 0.7), cutter, 12.0);
  pcl::PointCloud<pcl::PointXYZI> given, found;
  measured(*surface, way, cutter, 1500, given);
  way.tips.clear();
  measured(*surface, way, cutter, 1500, found);
  ASSERT_EQ(given.size(), found.size());
  for (std::size_t i = 0; i < given.size(); ++i)
    ASSERT_NEAR(given[i].intensity, found[i].intensity, 1e-5);
}

TEST(AnyCutterRemoval, TheNumberOfThreadsChangesNothing)
{
  const SurfacePtr surface = dome();
  const CutterShape cutter = CutterShape::bullNose(6.0, 1.5);
  const CutterWay way = wayOf(straightPasses(*surface, columns(-13.0, 1.0, 27), 14.0, 0.7), cutter, 12.0);
  pcl::PointCloud<pcl::PointXYZI> one, other;
  const auto figures = measured(*surface, way, cutter, 3000, one, 1);
  for (const int threads : {2, 3}) {
    const auto f = measured(*surface, way, cutter, 3000, other, threads);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      ASSERT_TRUE(one[i].intensity == other[i].intensity || std::isnan(one[i].intensity)) << threads << ' ' << i;
    EXPECT_EQ(f.scallop.max.value, figures.scallop.max.value);
    EXPECT_EQ(f.scallop.max.position, figures.scallop.max.position);
    EXPECT_EQ(f.scallop.max.index, figures.scallop.max.index);
    EXPECT_EQ(f.scallop.p50, figures.scallop.p50);
    EXPECT_EQ(f.gouge.value, figures.gouge.value);
    EXPECT_EQ(f.gouge.index, figures.gouge.index);
  }
}

TEST(AnyCutterRemoval, WhatCannotBePlacedIsRefused)
{
  const SurfacePtr surface = dome();
  const CheckedPath passes = straightPasses(*surface, {-1.0, 0.0, 1.0}, 6.0, 1.0);
  const auto refusal = [&](const CutterShape& cutter, bool axes, std::size_t tips) {
    const auto path = toolpath(passes);
    for (ToolpathPoint& point : *path)
      point.getAxisVector3fMap() = Eigen::Vector3f(axes ? 1.0f : 0.0f, 0.0f, 0.0f);
    MaterialRemoval<pcl::PointXYZ> removal;
    removal.setQuiet(true);
    removal.setInputCloud(toCloud(sampleUniform(*surface, 2000, 1).points));
    removal.setInputToolpath(path);
    removal.setInputTips(Polyline(tips, Eigen::Vector3d::Zero()));
    removal.setCutter(cutter);
    removal.setScallopHeight(h);
    pcl::PointCloud<pcl::PointXYZI> stock;
    removal.compute(stock);
    EXPECT_TRUE(stock.empty());
    return removal.getStatus().message();
  };
  EXPECT_NE(refusal(CutterShape::bullNose(6.0, 1.0), false, 0).find("without a tool axis"), std::string::npos);
  EXPECT_NE(refusal(CutterShape::bullNose(6.0, 1.0), true, 5).find("5 tool tips are given"), std::string::npos);
  EXPECT_NE(refusal(CutterShape::taper(6.0, 10.0, 20.0), true, 0).find("setInputTips"), std::string::npos);
  EXPECT_NE(refusal(CutterShape::bullNose(6.0, 7.0), true, 0).find("setCutter"), std::string::npos);
}

} // namespace any_cutter_removal_test
