// SPDX-License-Identifier: BSD-3-Clause
// Clouds with points much closer in one direction than in the other, twice at one place, or with a step in density: which
// points the graph uses, and that even clouds do not change.
#include <pcl_spiral/cleaning/impl/clean_graph.h>

#include "support/sampling.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace even_spread_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

SurfacePtr
saddle()
{
  return quadric(250.0, -200.0, Region({rectangle(100.0, 80.0)}));
}

std::vector<Eigen::Vector3f>
floats(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector3f> result;
  for (const Eigen::Vector3d& p : points)
    result.push_back(p.cast<float>());
  return result;
}

struct Built {
  SurfaceGraph graph;
  GraphSource source;
};

Built
built(const std::vector<Eigen::Vector3f>& points)
{
  Built result;
  const Status status = buildCleanGraph(points, {}, result.graph, result.source);
  EXPECT_TRUE(status.ok()) << status.message();
  return result;
}

/** Distance of place \p p from the nearest of the graph's points. */
double
distanceFrom(const SurfaceGraph& graph, const Eigen::Vector3d& p)
{
  return (graph.position(graph.blocks().nearest(p)) - p).norm();
}

} // namespace

TEST(EvenSpread, EvenCloudsStayWhole)
{
  const SurfacePtr surface = saddle();
  for (const auto& points : {floats(sampleUniform(*surface, 20000, 1).points), floats(sampleScanLines(*surface, 1.0, 1.0, 2, 0.0).points),
                             floats(sampleScanLines(*surface, 0.5, 1.0, 2, 0.3).points)}) {
    const Built b = built(points);
    EXPECT_EQ(b.source.surplus, 0u);
    EXPECT_EQ(b.source.indices.size() + b.source.outliers.size(), points.size());
  }
}

TEST(EvenSpread, ScanLinesAreThinnedToAboutTheDistanceOfTheLines)
{
  const SurfacePtr surface = saddle();
  for (const double along : {0.2, 0.1, 0.04})
    for (const double jitter : {0.0, 0.3}) {
      const auto points = floats(sampleScanLines(*surface, along, 2.0, 3, jitter).points);
      const Built b = built(points);
      EXPECT_EQ(b.source.indices.size() + b.source.outliers.size() + b.source.surplus, points.size());
      EXPECT_EQ(b.graph.size(), b.source.indices.size());
      EXPECT_GT(b.graph.spacing(), 0.9) << along;
      EXPECT_LT(b.graph.spacing(), 2.1) << along;
      EXPECT_EQ(b.graph.neighbours(), 32) << along; // the stars need as many neighbours as in an even cloud
      double farthest = 0.0;                        // no hole is made: near every given point there is a kept point
      for (const Eigen::Vector3f& p : points)
        farthest = std::max(farthest, distanceFrom(b.graph, p.cast<double>()));
      EXPECT_LT(farthest, 2.0) << along;
    }
}

TEST(EvenSpread, TheSameSurfaceScannedTwiceCountsOnce)
{
  const SurfacePtr surface = saddle();
  const Sampled once = sampleUniform(*surface, 5000, 4);
  std::vector<Eigen::Vector3d> twice = once.points;
  for (std::size_t i = 0; i < once.points.size(); ++i)
    twice.push_back(once.points[i] + 0.02 * once.normals[i]);
  const Built b = built(floats(twice));
  EXPECT_GT(b.source.surplus, 4800u);
  EXPECT_LT(b.source.surplus, 6000u);
}

TEST(EvenSpread, BesideASparserPartTheSpacingFallsEvenly)
{
  const SurfacePtr surface = saddle();
  const auto all = sampleUniform(*surface, 200000, 5).points; // 0.2 mm, and 2 mm from x = 10 on
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].x() < 10.0 || i % 100 == 0)
      points.push_back(all[i]);
  const Built b = built(floats(points));
  EXPECT_GT(b.source.surplus, 1000u);
  for (std::size_t i = 0; i < b.graph.size(); ++i) {
    const double x = b.graph.position(i).x();
    if (x > 9.5 && x < 10.0) {
      EXPECT_GT(b.graph.spacing(i), 0.6);
    }
    if (x < -10.0) {
      EXPECT_LT(b.graph.spacing(i), 0.4); // far away all are kept
    }
  }
}

TEST(EvenSpread, FalsePointsAreNotKeptForTheRarePointsTheyAre)
{
  const SurfacePtr surface = saddle();
  Sampled lines = sampleScanLines(*surface, 0.1, 1.0, 6, 0.1);
  const std::size_t honest = lines.points.size();
  Random random(7);
  for (std::size_t i = 0; i < honest / 50; ++i) {
    const std::size_t k = random.below(honest);
    lines.points.push_back(lines.points[k] + random.uniform(5.0, 15.0) * (i % 2 ? 1.0 : -1.0) * lines.normals[k]);
  }
  const Built b = built(floats(lines.points));
  std::size_t false_points = 0;
  for (const std::uint32_t i : b.source.indices)
    false_points += i >= honest;
  EXPECT_EQ(false_points, 0u);
}

TEST(EvenSpread, TheOrderOfThePointsDoesNotMatter)
{
  const auto points = floats(sampleScanLines(*saddle(), 0.1, 1.0, 8, 0.2).points);
  std::vector<Eigen::Vector3f> mixed;
  const std::vector<std::size_t> order = shuffled(points.size(), 9);
  for (const std::size_t i : order)
    mixed.push_back(points[i]);
  const Built a = built(points), b = built(mixed);
  const std::set<std::size_t> kept(a.source.indices.begin(), a.source.indices.end());
  ASSERT_EQ(a.source.indices.size(), b.source.indices.size());
  for (const std::uint32_t i : b.source.indices)
    EXPECT_EQ(kept.count(order[i]), 1u);
}

TEST(EvenSpread, WhichPointsOfALineStayDoesNotDependOnTheirNoise)
{
  constexpr double sigma = 0.02;
  const SurfacePtr plate = flat(Region({rectangle(110.0, 90.0)}));
  Sampled lines = sampleScanLines(*plate, 0.2, 2.0, 1, 0.1); // y equal all along a line, x nearly even
  addNoise(lines, sigma, 3);
  const Built result = built(floats(lines.points));
  EXPECT_GT(result.source.surplus, lines.points.size() / 2);
  double mean = 0.0;
  for (std::size_t i = 0; i < result.graph.size(); ++i)
    mean += result.graph.position(i).z() / static_cast<double>(result.graph.size());
  EXPECT_LT(std::abs(mean), 4.0 * sigma / std::sqrt(static_cast<double>(result.graph.size())));
}

} // namespace even_spread_test
