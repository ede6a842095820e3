// SPDX-License-Identifier: BSD-3-Clause
// Gaps of a scan: the path runs over them, marked, or they are refused; the path over them is on the true surface.
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace scan_gaps_test {

namespace {

using namespace pcl_spiral;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double radius = 150.0; // of the sphere
constexpr double spacing = 0.75; // about: 20,000 points within 60 mm

/** A gap in the plan of the part, and the distance of a place from its edge (negative: outside). */
struct Gap {
  test::PlaneLoop outline;
  std::function<double(double, double)> depth;
};

Gap
spot(double x, double y, double r)
{
  return {test::circle({x, y}, r), [=](double u, double v) { return r - std::hypot(u - x, v - y); }};
}

SpiralToolpathGenerator<pcl::PointXYZ>
generatorFor(const std::vector<Gap>& gaps, double noise)
{
  std::vector<test::PlaneLoop> outlines{test::circle({0, 0}, 60.0)};
  for (const Gap& gap : gaps)
    outlines.push_back(gap.outline);
  auto sampled = test::sampleUniform(*test::ball(radius, test::Region(outlines)), 20000, 4);
  test::Random random(9);
  for (std::size_t i = 0; i < sampled.points.size(); ++i)
    sampled.points[i] += noise * random.normal() * sampled.normals[i];
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setInputCloud(test::toCloud(sampled.points));
  generator.setToolRadius(5.0);
  generator.setScallopHeight(0.02);
  return generator;
}

bool
hasPointNear(const pcl::PointCloud<pcl::PointXYZ>& scan, const ToolpathPoint& p)
{
  return std::any_of(scan.begin(), scan.end(),
                     [&p](const pcl::PointXYZ& q) { return (q.getVector3fMap() - p.getVector3fMap()).norm() < spacing; });
}

/** The path is marked well inside the gaps and not well outside, unless by chance no point of the scan is near; it is near the
 *  sphere everywhere. */
void
expectMarked(const pcl::PointCloud<pcl::PointXYZ>& scan, const Path& path, const std::vector<Gap>& gaps, double deviation)
{
  std::size_t inside = 0, wrong = 0;
  double worst = 0.0;
  for (const ToolpathPoint& p : path) {
    double depth = -1e9;
    for (const Gap& gap : gaps)
      depth = std::max(depth, gap.depth(p.x, p.y));
    inside += depth > 1.5 * spacing;
    wrong += depth > 1.5 * spacing ? p.over_gap != 1 : depth < -1.5 * spacing && p.over_gap != 0 && hasPointNear(scan, p);
    worst = std::max(worst, std::abs(p.getVector3fMap().cast<double>().norm() - radius));
  }
  std::printf("  %zu of %zu points well inside gaps, largest deviation %.5f mm\n", inside, path.size(), worst);
  EXPECT_GT(inside, 100u);
  EXPECT_EQ(wrong, 0u);
  EXPECT_LT(worst, deviation);
}

/** The report and the path agree on gaps. */
void
expectReported(const Path& path, const SpiralReport& report)
{
  std::size_t marked = 0;
  double length = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    marked += path[i].over_gap;
    if (i > 0 && (path[i].over_gap || path[i - 1].over_gap))
      length += path[i].arc_length - path[i - 1].arc_length;
  }
  EXPECT_EQ(report.gap_points, marked);
  EXPECT_NEAR(report.gap_length, length, 1e-6);
}

// One of 14 spacings, one at the centre of the spiral, one four spacings from the rim.
const std::vector<Gap> spots{spot(20, 10, 5.2), spot(0, 0, 3.0), spot(-38, 38, 3.0)};

TEST(ScanGaps, AreRiddenOverAndMarked)
{
  auto generator = generatorFor(spots, 0.0);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  expectMarked(*generator.getInputCloud(), path, spots, 0.003);
  expectReported(path, generator.getReport());
  EXPECT_EQ(generator.getReport().warnings.size(), spots.size() + 1);
}

TEST(ScanGaps, UnderNoiseTheBridgeStaysNear)
{
  const double noise = 0.05 * spacing;
  auto generator = generatorFor(spots, noise);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  expectMarked(*generator.getInputCloud(), path, spots, 1.5 * noise);
}

TEST(ScanGaps, ARealHoleIsRiddenOverWhenOneBoundaryIsAskedFor)
{
  // The shadow of a clamp, 8 by 40 mm.
  const std::vector<Gap> shadow{{test::rectangle(40, 8, {-15, 20}), [](double u, double v) {
                                   return std::min({u + 35, 5 - u, v - 16, 24 - v});
                                 }}};
  auto generator = generatorFor(shadow, 0.0);
  generator.setBoundaryMode(BoundaryMode::OneBoundary);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  expectMarked(*generator.getInputCloud(), path, shadow, 0.03); // far beyond fifteen spacings
  generator.setBoundaryMode(BoundaryMode::Automatic);
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  EXPECT_EQ(generator.getReport().boundaries, 2u);
  for (const ToolpathPoint& p : path)
    ASSERT_EQ(p.over_gap, 0);
}

TEST(ScanGaps, TheLongestHoleIsTheSecondBoundaryWhereTwoAreAskedFor)
{
  // 38 mm long, a tenth of the rim: a gap by default, a boundary if the user asks for it.
  const std::vector<Gap> holes{spot(5.0, -4.0, 6.0), spot(30.0, 20.0, 3.0)};
  auto generator = generatorFor(holes, 0.0);
  generator.setBoundaryMode(BoundaryMode::TwoBoundaries);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  EXPECT_EQ(generator.getReport().boundaries, 2u);
  double nearest = 1e9;
  std::size_t over_other = 0;
  for (const ToolpathPoint& p : path) {
    nearest = std::min(nearest, std::hypot(p.x - 5.0, p.y + 4.0));
    over_other += std::hypot(p.x - 30.0, p.y - 20.0) < 1.5;
  }
  EXPECT_NEAR(nearest, 6.0, 0.5 * spacing) << "round the hole, and not over it";
  EXPECT_GT(over_other, 0u) << "the shorter one is bridged";
}

TEST(ScanGaps, AreRefusedWithTheirPlaceWhenAskedFor)
{
  auto generator = generatorFor(spots, 0.0);
  generator.setGapHandling(GapHandling::Refuse);
  Path path;
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_TRUE(path.empty());
  double x = 0.0, y = 0.0, z = 0.0;
  const std::string message = generator.getStatus().message();
  const std::size_t at = message.find("gap at (");
  ASSERT_NE(at, std::string::npos) << message;
  ASSERT_EQ(std::sscanf(message.c_str() + at, "gap at (%lf, %lf, %lf)", &x, &y, &z), 3) << message;
  double nearest = 1e9;
  for (const Gap& gap : spots)
    nearest = std::min(nearest, std::abs(gap.depth(x, y)));
  EXPECT_LT(nearest, 2.0 * spacing);
}

TEST(ScanGaps, APathWithoutGapsHasNoMarks)
{
  auto generator = generatorFor({}, 0.0);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  EXPECT_EQ(generator.getReport().gap_points, 0u);
  for (const ToolpathPoint& p : path)
    ASSERT_EQ(p.over_gap, 0);
}

} // namespace

} // namespace scan_gaps_test
