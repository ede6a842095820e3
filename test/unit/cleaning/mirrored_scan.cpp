// SPDX-License-Identifier: BSD-3-Clause
// A scan mirrored, or turned by 90 degrees, without rounding of coordinates: the same points, triangles and outlines.
#include <pcl_spiral/cleaning/impl/clean_graph.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include "support/sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <set>

namespace mirrored_scan_test {

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Matrix3d;
using Points = std::vector<Eigen::Vector3f>;

std::vector<Matrix3d>
exactMaps()
{
  Matrix3d mirror = Matrix3d::Identity(), quarter;
  mirror(0, 0) = -1.0;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return {mirror, quarter, mirror * quarter};
}

Points
mapped(const Sampled& scan, const Matrix3d& map)
{
  Points result;
  for (const Eigen::Vector3d& p : scan.points)
    result.push_back(map.cast<float>() * p.cast<float>());
  return result;
}

struct Built {
  SurfaceGraph graph;
  GraphSource source;
};

Built
built(Points points)
{
  Built result;
  const Status status = buildCleanGraph(std::move(points), {}, result.graph, result.source);
  EXPECT_TRUE(status.ok()) << status.message();
  return result;
}

std::set<std::array<std::uint32_t, 3>>
triangles(const Built& built)
{
  std::set<std::array<std::uint32_t, 3>> result;
  const Triangulation& mesh = built.graph.triangulation();
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    std::array<std::uint32_t, 3> corners = mesh.triangle(t);
    for (std::uint32_t& v : corners)
      v = built.source.indices[built.graph.blocks().originalIndex(v)];
    std::sort(corners.begin(), corners.end());
    result.insert(corners);
  }
  return result;
}

/** Noise large enough that neighbours disagree on triangles. */
Sampled
noisy(const SurfacePtr& surface, double noise, std::uint64_t seed)
{
  Sampled scan = sampleUniform(*surface, 2500, seed);
  addNoise(scan, noise, seed + 1);
  return scan;
}

TEST(MirroredScan, HasTheSameTriangles)
{
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Sampled scan = noisy(quadric(90.0, -70.0, Region({circle({0, 0}, 40.0, 512)})), 0.3, seed);
    const auto expected = triangles(built(mapped(scan, Matrix3d::Identity())));
    ASSERT_GT(expected.size(), scan.points.size());
    for (const Matrix3d& map : exactMaps())
      EXPECT_TRUE(triangles(built(mapped(scan, map))) == expected) << "seed " << seed << ", map\n" << map;
  }
}

TEST(MirroredScan, KeepsTheSamePointsOfScanLines)
{
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    Sampled scan = sampleScanLines(*quadric(90.0, 200.0, Region({ell(80.0, 35.0)})), 0.4, 2.0, seed);
    addNoise(scan, 0.05, seed);
    std::vector<std::uint32_t> expected = built(mapped(scan, Matrix3d::Identity())).source.indices;
    std::sort(expected.begin(), expected.end());
    EXPECT_LT(expected.size(), scan.points.size());
    for (const Matrix3d& map : exactMaps()) {
      std::vector<std::uint32_t> kept = built(mapped(scan, map)).source.indices;
      std::sort(kept.begin(), kept.end());
      EXPECT_TRUE(kept == expected) << "seed " << seed << ", map\n" << map;
    }
  }
}

BoundaryLoop
rimOf(const Built& built)
{
  std::vector<BoundaryLoop> loops;
  const Status status = findBoundaryLoops(built.graph, {}, loops);
  EXPECT_TRUE(status.ok()) << status.message();
  return loops.empty() ? BoundaryLoop() : loops.front();
}

TEST(MirroredScan, HasTheSameOutline)
{
  const std::vector<Region> regions{Region({rectangle(80.0, 60.0)}), Region({star(5, 40.0, 22.0)}), Region({ell(80.0, 35.0)}),
                                    Region({kidney(40.0, 25.0, 0.02, 512)})};
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (const std::uint64_t seed : {11, 12, 13}) {
      const Sampled scan = noisy(ball(150.0, regions[r]), 0.15, seed);
      const Built first = built(mapped(scan, Matrix3d::Identity()));
      const BoundaryLoop expected = rimOf(first);
      ASSERT_GT(expected.curve.size(), 100u);
      const double tolerance = 5e-3 * first.graph.spacing();
      for (const Matrix3d& map : exactMaps()) {
        const BoundaryLoop rim = rimOf(built(mapped(scan, map)));
        ASSERT_EQ(rim.corners.size(), expected.corners.size()) << "region " << r << ", seed " << seed;
        ASSERT_EQ(rim.curve.size(), expected.curve.size()) << "region " << r << ", seed " << seed;
        // It begins at the same place, and runs in the opposite sense if the part is mirrored.
        const std::size_t n = rim.curve.size();
        for (std::size_t i = 0; i < n; ++i) {
          const std::size_t k = map.determinant() > 0.0 ? i : (n - i) % n;
          ASSERT_LT((map.transpose() * rim.curve[k] - expected.curve[i]).norm(), tolerance)
              << "region " << r << ", seed " << seed << ", node " << i;
        }
      }
    }
}

} // namespace

} // namespace mirrored_scan_test
