// SPDX-License-Identifier: BSD-3-Clause
// Outliers close to exact surfaces are found, and no other points.
#include "cleaning/spike_outliers.h"
#include <pcl_spiral/cleaning/impl/clean_graph.h>

#include "support/sampling.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

#include <omp.h>

#include <algorithm>
#include <cmath>

namespace spike_outliers_test {

namespace {

using namespace pcl_spiral;

constexpr double spacing = 2.0;

std::vector<Eigen::Vector3f>
single(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector3f> floats;
  for (const Eigen::Vector3d& p : points)
    floats.push_back(p.cast<float>());
  return floats;
}

test::Sampled
scanOf(const test::AnalyticSurface& surface, double noise, std::uint64_t seed)
{
  test::Sampled scan = test::sampleUniform(surface, static_cast<std::size_t>(surface.area() / (spacing * spacing)), seed);
  if (noise > 0.0)
    test::addNoise(scan, noise, seed + 1);
  return scan;
}

std::vector<std::uint32_t>
outliersOf(const std::vector<Eigen::Vector3f>& points)
{
  SurfaceGraph graph;
  EXPECT_TRUE(graph.build(points, {}).ok());
  std::vector<std::uint32_t> found = spikeOutliers(graph);
  found.insert(found.end(), graph.isolatedPoints().begin(), graph.isolatedPoints().end());
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/** Number of elements of the first list in the second, both ascending. */
std::size_t
countOf(const std::vector<std::uint32_t>& some, const std::vector<std::uint32_t>& all)
{
  return static_cast<std::size_t>(
      std::count_if(some.begin(), some.end(), [&](std::uint32_t i) { return std::binary_search(all.begin(), all.end(), i); }));
}

std::vector<test::SurfacePtr>
surfaces()
{
  return {test::spheroidCap(90.0, 50.0), test::freeform(), test::ovalSaddle(), test::bowl(),
          test::flat(test::Region({test::rectangle(110.0, 90.0), test::circle({10.0, 5.0}, 18.0)}))};
}

TEST(SpikeOutliers, NextToNoneOnTrueSurfaces)
{
  for (const test::SurfacePtr& surface : surfaces())
    for (const double noise : {0.0, 0.02 * spacing, 0.1 * spacing}) {
      const auto points = single(scanOf(*surface, noise, 7).points);
      EXPECT_LE(outliersOf(points).size(), noise > 0.0 ? 2 + points.size() / 20000 : 0u) << surface->area() << " mm^2, noise " << noise;
    }
}

TEST(SpikeOutliers, ThoseThatWereMovedOffAreFoundAndHardlyAnother)
{
  for (const test::SurfacePtr& surface : surfaces()) {
    test::Sampled scan = scanOf(*surface, 0.0, 11);
    std::vector<std::uint32_t> slightly, clearly, both;
    for (std::uint32_t i = 40; i < scan.points.size(); i += 97) { // 0.1 to 0.9 spacings off, either side
      const std::size_t k = both.size();
      scan.points[i] += spacing * (0.1 + 0.2 * static_cast<double>(k % 5)) * (k % 2 ? 1.0 : -1.0) * scan.normals[i];
      (k % 5 ? clearly : slightly).push_back(i);
      both.push_back(i);
    }
    const std::vector<std::uint32_t> found = outliersOf(single(scan.points));
    EXPECT_GE(countOf(clearly, found), clearly.size() - clearly.size() / 50 - 1) << // the rest hide each other
        surface->area() << " mm^2";
    EXPECT_GE(countOf(slightly, found), slightly.size() - slightly.size() / 15 - 1) << surface->area() << " mm^2";
    EXPECT_LE(found.size() - countOf(both, found), both.size() / 50 + 1) << surface->area() << " mm^2";
  }
}

TEST(SpikeOutliers, EdgesAndCornersKeepTheirPoints)
{
  const test::SurfacePtr square = test::flat(test::Region({test::rectangle(200.0, 200.0)}));
  std::vector<Eigen::Vector3f> roof = single(scanOf(*square, 0.0, 5).points), corner = roof;
  for (std::size_t i = 0; i < roof.size(); ++i) {
    roof[i].z() = -std::abs(roof[i].x());                                        // a right angle
    corner[i].z() = -std::max(std::abs(corner[i].x()), std::abs(corner[i].y())); // a pyramid
  }
  EXPECT_LE(outliersOf(roof).size(), roof.size() / 1000);
  EXPECT_LE(outliersOf(corner).size(), corner.size() / 1000);
}

TEST(SpikeOutliers, TheGraphIsOfTheOthersWithTheirIndicesAndNormalsForAnyNumberOfThreads)
{
  test::Sampled scan = scanOf(*test::spheroidCap(90.0, 50.0), 0.0, 13);
  for (std::size_t i = 5; i < scan.points.size(); i += 50)
    scan.points[i] -= 0.4 * spacing * scan.normals[i];
  const std::vector<Eigen::Vector3f> points = single(scan.points);
  SurfaceGraphOptions options;
  for (const Eigen::Vector3d& n : scan.normals)
    options.given_normals.push_back(-n.cast<float>()); // as if the material were outside
  SurfaceGraph first;
  GraphSource kept;
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    SurfaceGraph graph;
    GraphSource source;
    ASSERT_TRUE(buildCleanGraph(points, options, graph, source).ok());
    ASSERT_EQ(graph.size(), source.indices.size());
    const std::size_t moved = (points.size() - 5 + 49) / 50;
    EXPECT_GE(source.outliers.size(), moved);
    EXPECT_LE(source.outliers.size(), moved + 20); // with points of the rim, of about 280, that stand alone
    EXPECT_EQ(source.indices.size() + source.outliers.size(), points.size());
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const std::uint32_t from = source.indices[graph.blocks().originalIndex(i)];
      EXPECT_NE(from % 50, 5u);
      EXPECT_EQ(points[from], graph.blocks().point(i));
      EXPECT_LT(graph.normal(i).dot(scan.normals[from]), 0.0);
    }
    if (threads == 1)
      kept = source;
    EXPECT_EQ(source.indices, kept.indices);
  }
}

} // namespace

} // namespace spike_outliers_test
