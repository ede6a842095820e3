// SPDX-License-Identifier: BSD-3-Clause
// When stock falls: at the end and after any part of the path it is as high as the judge measures it.
#include "verify/stock_falls.h"
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/planning/impl/path_judging.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include "support/passes.h"
#include "support/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stock_falls_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double h = 0.05;

/** A cutter on passes over a dome, and the judge's view of it. */
struct JudgedDome {
  explicit JudgedDome(const CutterShape& shape) : cutter(shape)
  {
    const SurfacePtr surface = ball(80.0, Region({circle({0, 0}, 14.0)}));
    cloud = toCloud(sampleUniform(*surface, 6000, 1).points);
    const double pitch = cutter.corner_radius > 2.0 ? exactStepOver(cutter.corner_radius, h, 1.0 / 80.0) : 2.0;
    std::vector<double> us;
    for (double u = -15.0; u <= 15.0; u += pitch)
      us.push_back(u);
    path = toolpath(straightPasses(*surface, us, 15.0, 0.7));
  }

  /** Stock of the first \p moves moves. */
  std::vector<float> judge(std::size_t moves)
  {
    auto begin = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
    begin->assign(path->begin(), path->begin() + static_cast<std::ptrdiff_t>(moves) + 1, 0);
    JudgeSettings settings;
    settings.cutter = cutter;
    settings.scallop_height = h;
    Heights heights;
    const Status status = judgePath(
        cloud, begin, settings, [](double, const std::string&) { return true; }, reference, verification, heights);
    EXPECT_TRUE(status.ok()) << status.message();
    return heights.stock;
  }

  std::unique_ptr<CutterSweep> sweep() const
  {
    CutterPath moves;
    std::unique_ptr<CutterSweep> result;
    EXPECT_TRUE(readCutterPath(path, moves).ok());
    EXPECT_TRUE(makeSweep(moves, cutter, {}, result).ok());
    return result;
  }

  CutterShape cutter;
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;
  pcl::PointCloud<ToolpathPoint>::Ptr path;
  std::shared_ptr<const ReferenceSurface> reference;
  Verification verification;
};

std::vector<CutterShape>
cutters()
{
  return {CutterShape::ball(10.0), CutterShape::bullNose(4.0, 1.5), CutterShape::taperedBall(5.0, 15.0, 10.0)};
}

} // namespace

TEST(StockFalls, AfterAnyMoveTheStockIsThatOfThePathUpToThere)
{
  for (const CutterShape& cutter : cutters()) {
    JudgedDome dome(cutter);
    const std::size_t all = dome.path->size() - 1;
    const std::vector<float> left = dome.judge(all);
    const StockMesh mesh = stockMesh(*dome.reference, left);
    const RemovalReport judged = dome.verification.removal;
    StockFallSettings settings;
    settings.reach = judged.reach;
    const StockFalls falls = stockFalls(mesh, *dome.sweep(), settings);
    ASSERT_EQ(falls.places(), mesh.places.size());
    ASSERT_GT(falls.places(), 5000U);
    for (const std::size_t moves : {all, all / 2, all / 3 + 5}) {
      const StockMesh then = stockMesh(*dome.reference, dome.judge(moves));
      ASSERT_EQ(dome.verification.removal.reach, judged.reach);
      ASSERT_EQ(then.places.size(), falls.places());
      const double tolerance = moves == all ? 1e-3 : settings.step + 1e-3;
      std::size_t lower = 0;
      for (std::size_t i = 0; i < falls.places(); ++i) {
        ASSERT_NEAR(falls.heightAfter(i, moves), then.stock[i], tolerance)
            << "radius " << cutter.radius << " place " << i << " moves " << moves;
        lower += falls.heightAfter(i, moves) < falls.reach ? 1 : 0;
      }
      EXPECT_GT(lower, falls.places() / 5);
      EXPECT_TRUE(moves == all || lower < 4 * falls.places() / 5) << lower;
    }
  }
}

TEST(StockFalls, OfManyPlacesTheWorstOfEachNeighbourhoodIsKept)
{
  constexpr std::size_t most = 700;
  JudgedDome dome(CutterShape::ball(10.0));
  std::vector<float> stock = dome.judge(dome.path->size() - 1);
  const auto measured = std::find_if(stock.begin() + 2000, stock.end(), [](float value) { return !std::isnan(value); });
  *measured = -0.7f; // a gouge at one point
  const StockMesh whole = stockMesh(*dome.reference, stock), thin = stockMesh(*dome.reference, stock, most);
  EXPECT_LE(thin.places.size(), most);
  EXPECT_GT(thin.places.size(), most / 3);
  EXPECT_EQ(*std::min_element(thin.stock.begin(), thin.stock.end()), -0.7f);
  EXPECT_EQ(*std::max_element(thin.stock.begin(), thin.stock.end()), *std::max_element(whole.stock.begin(), whole.stock.end()));
  for (std::size_t i = 0; i < thin.places.size(); ++i) {
    const auto same = std::find(whole.places.begin(), whole.places.end(), thin.places[i]);
    ASSERT_NE(same, whole.places.end()) << "a place of its own";
    ASSERT_EQ(thin.stock[i], whole.stock[static_cast<std::size_t>(same - whole.places.begin())]);
  }
  double area = 0.0;
  for (const auto& [a, b, c] : thin.triangles) {
    ASSERT_LT(std::max({a, b, c}), thin.places.size());
    area += 0.5 * (thin.places[b] - thin.places[a]).cross(thin.places[c] - thin.places[a]).z();
  }
  EXPECT_NEAR(area, pi * 14.0 * 14.0, 0.15 * pi * 14.0 * 14.0) << "seen from above: a rim is lost, no triangle is turned";
}

TEST(StockFalls, StockNeverRisesAndItsFallsAreFew)
{
  JudgedDome dome(CutterShape::ball(10.0));
  const StockMesh mesh = stockMesh(*dome.reference, dome.judge(dome.path->size() - 1));
  StockFallSettings settings;
  settings.reach = dome.verification.removal.reach;
  const StockFalls falls = stockFalls(mesh, *dome.sweep(), settings);
  for (std::size_t place = 0; place < falls.places(); ++place) {
    float height = falls.reach;
    std::uint32_t move = 0;
    ASSERT_LE(falls.begins[place + 1] - falls.begins[place], settings.reach / settings.step + 2.0);
    for (std::uint32_t i = falls.begins[place]; i < falls.begins[place + 1]; ++i) {
      ASSERT_LT(falls.falls[i].height, height);
      ASSERT_TRUE(i == falls.begins[place] || falls.falls[i].move > move);
      height = falls.falls[i].height;
      move = falls.falls[i].move;
    }
  }
}

TEST(StockFalls, GoingOnAndBackGivesTheSameHeights)
{
  JudgedDome dome(CutterShape::ball(10.0));
  const std::size_t all = dome.path->size() - 1;
  const StockMesh mesh = stockMesh(*dome.reference, dome.judge(all));
  StockFallSettings settings;
  settings.reach = dome.verification.removal.reach;
  const StockFalls falls = stockFalls(mesh, *dome.sweep(), settings);
  const FallOrder order(falls);
  std::vector<float> heights(falls.places(), falls.reach);
  std::size_t now = 0, changes = 0;
  for (const std::size_t moves : {all / 4, all / 4 + 1, all / 2, all / 3, all, std::size_t{0}, all - 1}) {
    order.update(falls, now, moves, heights, [&](std::size_t) { ++changes; });
    now = moves;
    for (std::size_t place = 0; place < falls.places(); ++place)
      ASSERT_EQ(heights[place], falls.heightAfter(place, moves)) << moves;
  }
  changes = 0;
  order.update(falls, now, now, heights, [&](std::size_t) { ++changes; });
  EXPECT_EQ(changes, 0U);
}

} // namespace stock_falls_test
