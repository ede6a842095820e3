// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths over given edges: those of the elliptic Gabriel graph.
#include "support/even_cloud.h"
#include "support/surfaces.h"

#include "geodesic/dijkstra_tree.h"
#include <pcl_spiral/search/impl/gabriel_edges.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace dijkstra_tree_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

class OverGabrielEdges : public ::testing::Test {
protected:
  const SurfaceGraph graph_ = test::graphOf(test::sampleUniform(*test::flat(test::Region({test::rectangle(200, 200)})), 20000, 7).points);
  const NeighbourLists edges_ = ellipticGabrielEdges(graph_.blocks().points(), {}, GabrielOptions());
};

TEST_F(OverGabrielEdges, NoEdgeIsAShortCut)
{
  const std::uint32_t from = graph_.blocks().nearest(Vector3d(3, 5, 0));
  DijkstraTree tree;
  ASSERT_TRUE(tree.compute(graph_, edges_, graph_.position(from)));
  EXPECT_EQ(tree.distance(from), 0.0);
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    double before = DijkstraTree::unreached; // by the best edge that leads to i
    for (const std::uint32_t j : edges_[i])
      before = std::min(before, tree.distance(j) + (graph_.position(j) - graph_.position(i)).norm());
    if (i != from) {
      EXPECT_NEAR(tree.distance(i), before, 1e-9);
    }
  }
}

TEST_F(OverGabrielEdges, PathsKeepToTheEdges)
{
  DijkstraTree tree;
  ASSERT_TRUE(tree.compute(graph_, edges_, graph_.position(0)));
  for (std::uint32_t i = 100; i < graph_.size(); i += 97) {
    const Polyline path = tree.path(graph_.position(i));
    ASSERT_GE(path.size(), 2u);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const std::uint32_t a = graph_.blocks().nearest(path[k - 1]), b = graph_.blocks().nearest(path[k]);
      EXPECT_TRUE(a == b || edges_.contains(a, b));
    }
    EXPECT_NEAR(length(path), tree.distance(i), 1e-9);
  }
}

TEST_F(OverGabrielEdges, StretchThatDoesNotVanish)
{
  DijkstraTree tree;
  ASSERT_TRUE(tree.compute(graph_, edges_, Vector3d(0, 0, 0)));
  double sum = 0.0;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    const double straight = graph_.position(i).norm();
    if (straight < 60.0 || straight > 95.0)
      continue;
    ++count;
    sum += length(tree.path(graph_.position(i))) / straight;
  }
  std::printf("  mean stretch %.4f over %zu paths\n", sum / count, count);
  EXPECT_NEAR(sum / count, 1.049, 0.01);
}

} // namespace

} // namespace dijkstra_tree_test
