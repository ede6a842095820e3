// SPDX-License-Identifier: BSD-3-Clause
// Paths whose points are in no order are refused at once; sparse, dense and repeated paths are not.
#include "verify/path_order.h"
#include <pcl_spiral/verify/material_removal.h>

#include "support/passes.h"
#include "support/reference.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace path_order_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

Status
orderOf(const Polyline& points)
{
  CutterPath path;
  path.contacts = points;
  return checkOrder(path);
}

/** A path from corner to corner of squares that shrink by \p step. */
Polyline
squares(double side, double step)
{
  Polyline points;
  for (double half = 0.5 * side; half > step; half -= step)
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      points.emplace_back(x * half, y * half, 0.0);
  return points;
}

/** Rows round a column, as close as the points of a row. */
Polyline
helix(double radius, double height, double step)
{
  Polyline points;
  const double turn = step / radius;
  for (int i = 0; step * turn / (2.0 * M_PI) * i < height; ++i)
    points.emplace_back(radius * std::cos(turn * i), radius * std::sin(turn * i), step * turn / (2.0 * M_PI) * i);
  return points;
}

Polyline
inOrder(const Polyline& points, const std::vector<std::size_t>& order)
{
  Polyline result;
  for (const std::size_t i : order)
    result.push_back(points[i]);
  return result;
}

} // namespace

TEST(PathOrder, PathsInOrderAreTaken)
{
  EXPECT_TRUE(orderOf(squares(300.0, 0.1)).ok()); // far longer moves than the distance of the points
  EXPECT_TRUE(orderOf(helix(20.0, 60.0, 0.4)).ok());
  Polyline twice = helix(20.0, 60.0, 0.4);
  const Polyline once = twice;
  twice.insert(twice.end(), once.rbegin(), once.rend());
  EXPECT_TRUE(orderOf(twice).ok());
  EXPECT_TRUE(orderOf({{0, 0, 0}, {1, 0, 0}}).ok());
}

TEST(PathOrder, ShuffledAndSortedTablesAreRefused)
{
  const Polyline points = helix(20.0, 60.0, 0.4);
  const Status status = orderOf(inOrder(points, shuffled(points.size(), 5)));
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message().find("order of the path"), std::string::npos) << status.message();
  Polyline by_x = points;
  std::sort(by_x.begin(), by_x.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  EXPECT_FALSE(orderOf(by_x).ok());
}

TEST(PathOrder, TheJudgeRefusesAtOnceForEveryCutter)
{
  const SurfacePtr surface = ball(80.0, Region({circle({0, 0}, 40.0)}));
  std::vector<double> columns;
  for (double u = -40.0; u <= 40.0; u += 2.0)
    columns.push_back(u);
  const auto path = toolpath(straightPasses(*surface, columns, 40.0, 0.5));
  pcl::PointCloud<ToolpathPoint>::Ptr mixed(new pcl::PointCloud<ToolpathPoint>);
  for (const std::size_t i : shuffled(path->size(), 6)) {
    mixed->push_back((*path)[i]);
    mixed->back().arc_length = mixed->size(); // as found for a table of tips
    mixed->back().getAxisVector3fMap() = mixed->back().getNormalVector3fMap();
  }
  for (const CutterShape& cutter : {CutterShape::ball(3.0), CutterShape::bullNose(3.0, 1.0, 10.0), CutterShape::flatEnd(3.0, 10.0)}) {
    MaterialRemoval<pcl::PointXYZ> removal;
    removal.setQuiet(true);
    removal.setInputCloud(toCloud(sampleUniform(*surface, 5000, 1).points));
    removal.setInputToolpath(mixed);
    removal.setCutter(cutter);
    removal.setScallopHeight(0.02);
    pcl::PointCloud<pcl::PointXYZI> stock;
    removal.compute(stock);
    EXPECT_NE(removal.getStatus().message().find("order of the path"), std::string::npos) << removal.getStatus().message();
  }
}

} // namespace path_order_test
