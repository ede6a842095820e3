// SPDX-License-Identifier: BSD-3-Clause
// A side of an outline that goes to and fro is no fit, however long the line is that it started from.
#include "features/side_fit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace side_fit_test {

using namespace pcl_spiral;

namespace {

constexpr double width = 60.0;

SurfaceGraph
square()
{
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j)
      points.emplace_back(float(i), float(j), 0.0f);
  SurfaceGraph graph;
  EXPECT_TRUE(graph.build(points, {}).ok());
  return graph;
}

/** The lower edge of the square, or a line \p high to and fro across it. */
EdgeSide
lowerEdge(double high)
{
  Polyline line;
  for (int i = 0; i <= 1200; ++i) {
    const double x = width * i / 1200.0;
    line.emplace_back(x, high * std::sin(x), 0.0);
  }
  return smoothSide(line, false, 0.2);
}

std::vector<ExpectedPoint>
edgePoints()
{
  std::vector<ExpectedPoint> points;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 3; ++j)
      points.push_back({Eigen::Vector3d(i, j, 0.0), i / width});
  return points;
}

} // namespace

TEST(SideFit, AStraightEdgeIsFound)
{
  const SurfaceGraph graph = square();
  const FittedSide fitted = fitSide(MlsSurface(graph), 1.0, lowerEdge(0.0), edgePoints(), width);
  EXPECT_TRUE(std::isfinite(fitted.outside));
  EXPECT_NEAR(length(fitted.side.nodes), width, 1.0);
}

TEST(SideFit, ASideMuchLongerThanTheRingIsNoFit)
{
  const SurfaceGraph graph = square();
  const EdgeSide start = lowerEdge(12.0);
  ASSERT_GT(length(start.nodes), 5.0 * width);
  const FittedSide fitted = fitSide(MlsSurface(graph), 1.0, start, edgePoints(), width);
  EXPECT_TRUE(std::isinf(fitted.outside));
}

} // namespace side_fit_test
