// SPDX-License-Identifier: BSD-3-Clause
// The pass of SpiralToolpathGenerator over all neighbourhoods against the single PCL-style classes with any of PCL's
// searches: both give the same neighbours, normals, boundary points and loops.
#include "support/sampling.h"

#include "search/neighbour_search.h"
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>

#include <gtest/gtest.h>

#include <cmath>

namespace fused_pass_test {

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Search = pcl::search::Search<pcl::PointXYZ>;
using Estimation = CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal>;

namespace {

/** Rounding of distances between points some hundred mm from the origin, in single precision, mm. */
constexpr double rounding = 1e-4;

struct Scan {
  Cloud::Ptr cloud;
  SurfaceGraph graph;
  Normals::Ptr normals; ///< of the graph, in the cloud's order
};

Scan
scanOf(const test::SurfacePtr& surface, double noise)
{
  test::Sampled sampled = test::sampleUniform(*surface, 8000, 3);
  test::addNoise(sampled, noise, 4);
  Scan scan;
  scan.cloud = test::toCloud(sampled.points);
  std::vector<Eigen::Vector3f> points;
  for (const auto& p : *scan.cloud)
    points.push_back(p.getVector3fMap());
  EXPECT_TRUE(scan.graph.build(points, SurfaceGraphOptions()).ok());
  scan.normals.reset(new Normals);
  scan.normals->resize(points.size());
  for (std::size_t i = 0; i < scan.graph.size(); ++i)
    (*scan.normals)[scan.graph.blocks().originalIndex(i)].getNormalVector3fMap() = scan.graph.normals()[i];
  return scan;
}

/** Parts with one boundary and with two, without and with noise. */
const std::vector<Scan>&
scans()
{
  static const std::vector<Scan> all{scanOf(test::spheroidCap(80.0, 45.0), 0.0), scanOf(test::spheroidCap(80.0, 45.0, 25.0), 0.0),
                                     scanOf(test::spheroidCap(80.0, 45.0), 0.02), scanOf(test::spheroidCap(80.0, 45.0, 25.0), 0.02)};
  return all;
}

std::vector<Search::Ptr>
searches()
{
  return {Search::Ptr(new pcl::search::KdTree<pcl::PointXYZ>), Search::Ptr(new pcl::search::Octree<pcl::PointXYZ>(2.0))};
}

Estimation
estimationOf(const Scan& scan, const Search::Ptr& search)
{
  Estimation estimation;
  estimation.setInputCloud(scan.cloud);
  estimation.setInputNormals(scan.normals);
  estimation.setKSearch(scan.graph.neighbours());
  estimation.setSearchMethod(search);
  return estimation;
}

/** Boundary evidence at point \p i of the graph from the pass. */
BoundaryEvidence
evidenceOf(const Scan& scan, const Neighbourhood& near, std::size_t i)
{
  Eigen::Vector3d u, v;
  tangentFrame(scan.graph.normal(i).normalized(), u, v);
  std::vector<Eigen::Vector2d> offsets;
  for (int j = 0; j < near.size; ++j)
    if (near.squared_distance[j] > 0.0f) {
      const Eigen::Vector3d d(near.x[j], near.y[j], near.z[j]);
      offsets.emplace_back(d.dot(u), d.dot(v));
    }
  std::vector<double> angles;
  return boundaryEvidence(offsets, scan.graph.radius(i), angles);
}

} // namespace

TEST(FusedPass, RadiusIsThatOfAnySearch)
{
  for (const Scan& scan : scans())
    for (const Search::Ptr& search : searches()) {
      search->setInputCloud(scan.cloud);
      pcl::Indices indices;
      std::vector<float> squared;
      for (std::size_t i = 0; i < scan.graph.size(); ++i) {
        const auto original = static_cast<int>(scan.graph.blocks().originalIndex(i));
        ASSERT_EQ(search->nearestKSearch(original, scan.graph.neighbours(), indices, squared), scan.graph.neighbours());
        ASSERT_NEAR(scan.graph.radius(i), std::sqrt(squared.back()), rounding) << search->getName() << ", point " << i;
      }
    }
}

TEST(FusedPass, NormalsAreThoseOfPclWithAnySearch)
{
  for (const Scan& scan : scans())
    for (const Search::Ptr& search : searches()) {
      pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
      estimation.setInputCloud(scan.cloud);
      estimation.setSearchMethod(search);
      estimation.setKSearch(scan.graph.neighbours());
      Normals normals;
      estimation.compute(normals);
      for (std::size_t i = 0; i < normals.size(); ++i) {
        const Eigen::Vector3d ours = (*scan.normals)[i].getNormalVector3fMap().cast<double>();
        const Eigen::Vector3d theirs = normals[i].getNormalVector3fMap().cast<double>();
        ASSERT_LT(ours.cross(theirs).norm(), 1e-3) << search->getName() << ", point " << i; // the sign may differ
      }
    }
}

TEST(FusedPass, BoundaryEvidenceIsThatOfTheFilterWithAnySearch)
{
  for (const Scan& scan : scans())
    for (const Search::Ptr& search : searches()) {
      Estimation estimation = estimationOf(scan, search);
      pcl::PointCloud<pcl::Boundary> marks;
      estimation.compute(marks);
      ASSERT_TRUE(estimation.getStatus().ok());
      const PointBlocks& blocks = scan.graph.blocks();
      NeighbourSearch neighbours(blocks, scan.graph.neighbours());
      std::size_t marked = 0, differing = 0;
      for (std::size_t b = 0; b < blocks.blockCount(); ++b) {
        neighbours.setRun(blocks.blockBox(b));
        for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i) {
          const BoundaryEvidence evidence = evidenceOf(scan, neighbours.find(blocks.position(i)), i);
          const std::size_t original = blocks.originalIndex(i);
          ASSERT_NEAR(evidence.offset, estimation.getOffsets()[original], 1e-4) << search->getName() << ", point " << i;
          ASSERT_NEAR(evidence.gap, estimation.getGaps()[original], 1e-3) << search->getName() << ", point " << i;
          const bool mark =
              isBoundary(evidence, estimation.getCriterion(), estimation.getOffsetThreshold(), estimation.getAngleThreshold());
          marked += mark;
          differing += mark != (marks[original].boundary_point != 0);
        }
      }
      EXPECT_GT(marked, 200U);
      EXPECT_LE(differing, 2U) << "but for points within rounding of the threshold";
    }
}

TEST(FusedPass, LoopsOfTheGeneratorAreThoseOfTheFiltersWithAnySearch)
{
  for (const Scan& scan : scans()) {
    SpiralToolpathGenerator<pcl::PointXYZ> generator;
    generator.setInputCloud(scan.cloud);
    generator.setToolRadius(3.0);
    generator.setScallopHeight(0.2);
    pcl::PointCloud<ToolpathPoint> path;
    generator.compute(path);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    const std::vector<BoundaryLoop>& expected = generator.getReport().loops;
    for (const Search::Ptr& search : searches()) {
      Estimation estimation = estimationOf(scan, search);
      const pcl::PointCloud<pcl::Boundary>::Ptr marks(new pcl::PointCloud<pcl::Boundary>);
      estimation.compute(*marks);
      BoundaryLoops<pcl::PointXYZ> filter;
      filter.setInputCloud(scan.cloud);
      filter.setBoundaryPoints(marks);
      std::vector<BoundaryLoop> loops;
      filter.compute(loops);
      ASSERT_EQ(loops.size(), expected.size()) << search->getName();
      for (std::size_t l = 0; l < loops.size(); ++l) {
        EXPECT_EQ(loops[l].type, expected[l].type);
        EXPECT_EQ(loops[l].indices, expected[l].indices) << search->getName() << ", loop " << l;
        EXPECT_EQ(loops[l].curve, expected[l].curve) << search->getName() << ", loop " << l;
        EXPECT_EQ(loops[l].length, expected[l].length);
      }
    }
  }
}

} // namespace fused_pass_test
