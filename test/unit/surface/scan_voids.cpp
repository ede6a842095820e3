// SPDX-License-Identifier: BSD-3-Clause
// Holes too narrow for open loops: distinguished from chance, marked on the path, opened if their size is given.
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/impl/scan_voids.h>

#include <gtest/gtest.h>

namespace scan_voids_test {

namespace {

using namespace pcl_spiral;
using Path = pcl::PointCloud<ToolpathPoint>;

/** About one point in 1.5 x 1.5 mm of a bowl 120 mm across, with a round hole of \p radius at (14, 9). */
std::vector<Eigen::Vector3d>
bowl(double radius, unsigned int seed)
{
  std::vector<test::PlaneLoop> outlines{test::circle({0, 0}, 60.0)};
  if (radius > 0.0)
    outlines.push_back(test::circle({14.0, 9.0}, radius));
  return test::sampleUniform(*test::ball(250.0, test::Region(outlines)), 5000, seed).points;
}

SurfaceGraph
graphOf(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector3f> floats;
  for (const Eigen::Vector3d& p : points)
    floats.push_back(p.cast<float>());
  SurfaceGraph graph;
  EXPECT_TRUE(graph.build(std::move(floats), {}).ok());
  return graph;
}

SpiralToolpathGenerator<pcl::PointXYZ>
generatorOf(const std::vector<Eigen::Vector3d>& points)
{
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setInputCloud(test::toCloud(points));
  generator.setToolRadius(5.0);
  generator.setScallopHeight(0.05);
  return generator;
}

TEST(ScanVoids, AreNotSeenWhereChanceAloneLeavesPlacesEmpty)
{
  std::size_t alarms = 0;
  for (unsigned int seed = 1; seed <= 60; ++seed)
    alarms += ScanVoids(graphOf(bowl(0.0, seed))).voids().size();
  EXPECT_LE(alarms, 5u); // predicted: one in fifty; six or more in sixty have a probability of 0.2 %
}

TEST(ScanVoids, AHoleOfFiveSpacingsIsFoundWithItsPlaceAndWidth)
{
  for (unsigned int seed = 1; seed <= 20; ++seed) {
    const SurfaceGraph graph = graphOf(bowl(4.0, seed));
    const ScanVoids found(graph);
    ASSERT_GE(found.voids().size(), 1u) << "seed " << seed;
    const auto near = std::min_element(found.voids().begin(), found.voids().end(), [](const auto& a, const auto& b) {
      return std::hypot(a.place.x() - 14.0, a.place.y() - 9.0) < std::hypot(b.place.x() - 14.0, b.place.y() - 9.0);
    });
    EXPECT_LT(std::hypot(near->place.x() - 14.0, near->place.y() - 9.0), 2.0) << "seed " << seed;
    EXPECT_GT(near->width, 8.0) << "seed " << seed;
    EXPECT_LT(near->width, 8.0 + 5.0) << "seed " << seed;
  }
}

TEST(ScanVoids, ThePathOverANarrowHoleIsMarkedAndReported)
{
  for (const SpiralMethod method : {SpiralMethod::Radial, SpiralMethod::ConstantScallop}) {
    auto generator = generatorOf(bowl(4.0, 3));
    generator.setMethod(method);
    Path path;
    generator.compute(path);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    std::size_t over = 0, unmarked = 0, wrong = 0;
    for (const ToolpathPoint& p : path) {
      const double off = std::hypot(p.x - 14.0, p.y - 9.0);
      over += off < 3.6;
      unmarked += off < 3.6 && !p.over_gap;
      wrong += off > 4.0 + 3.0 && p.over_gap;
    }
    EXPECT_GT(over, 10u);
    EXPECT_EQ(unmarked, 0u);
    EXPECT_EQ(wrong, 0u);
    ASSERT_EQ(generator.getReport().holes.size(), 1u);
    EXPECT_EQ(generator.getReport().holes[0].handling, HoleHandling::Over);
    EXPECT_NE(generator.getReport().warnings.back().text().find("marked"), std::string::npos);
  }
}

TEST(ScanVoids, ANarrowHoleIsGoneRoundWhereItsSizeIsGiven)
{
  auto generator = generatorOf(bowl(4.0, 3));
  generator.setMethod(SpiralMethod::ConstantScallop);
  generator.setHoleSize(6.0);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  for (const ToolpathPoint& p : path)
    ASSERT_GT(std::hypot(p.x - 14.0, p.y - 9.0), 4.0 - 1.0);
  ASSERT_EQ(generator.getReport().holes.size(), 1u);
  EXPECT_EQ(generator.getReport().holes[0].handling, HoleHandling::Around);
  EXPECT_NEAR(generator.getReport().holes[0].width, 8.0, 2.0);
}

TEST(Holes, AreGoneRoundOverOrRefused)
{
  auto generator = generatorOf(bowl(18.0, 5));
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  ASSERT_EQ(generator.getReport().holes.size(), 1u);
  EXPECT_EQ(generator.getReport().holes[0].handling, HoleHandling::Around);
  EXPECT_NEAR(generator.getReport().holes[0].width, 36.0, 1.5);
  EXPECT_LT((generator.getReport().holes[0].place.head<2>() - Eigen::Vector2d(14.0, 9.0)).norm(), 1.0);

  generator.setHoleHandling(HoleHandling::Over);
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  EXPECT_EQ(generator.getReport().holes[0].handling, HoleHandling::Over);
  for (const ToolpathPoint& p : path)
    if (std::hypot(p.x - 14.0, p.y - 9.0) < 15.0)
      ASSERT_EQ(p.over_gap, 1);

  generator.setHoleHandling(HoleHandling::Refuse);
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_NE(generator.getStatus().message().find("setHoleHandling"), std::string::npos);
  EXPECT_TRUE(path.empty());

  generator.setHoleSize(40.0); // then the hole is a gap in the data
  generator.compute(path);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
}

TEST(Holes, ContradictionsAreRefused)
{
  auto generator = generatorOf(bowl(18.0, 5));
  generator.setHoleHandling(HoleHandling::Over);
  generator.setBoundaryMode(BoundaryMode::TwoBoundaries);
  Path path;
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidArgument);
}

} // namespace

} // namespace scan_voids_test
