// SPDX-License-Identifier: BSD-3-Clause
// The pass along the rim inside it, on it and beyond it; the margin round holes; impossible cases are refused with the place.
#include "support/outlines.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

namespace rim_offset_test {

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Generator = SpiralToolpathGenerator<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double sphere = 250.0; // its radius

Generator
generatorOf(const AnalyticSurface& part, std::size_t count, SpiralMethod method)
{
  Generator generator;
  generator.setInputCloud(toCloud(sampleUniform(part, count, 7).points));
  generator.setMethod(method);
  generator.setToolRadius(5.0);
  generator.setScallopHeight(0.1);
  generator.setQuiet(true);
  return generator;
}

SurfacePtr
bowl(double hole)
{
  std::vector<PlaneLoop> loops{circle({0, 0}, 60.0)};
  if (hole > 0.0)
    loops.push_back(circle({0, 0}, hole));
  return ball(sphere, Region(loops));
}

/** Least and largest distance of the path from the axis, measured along the ball. */
std::pair<double, double>
reach(const Path& path)
{
  std::pair<double, double> found{1e9, 0.0};
  for (const ToolpathPoint& p : path) {
    const double r = sphere * std::atan2(std::hypot(p.x, p.y), p.z);
    found.first = std::min(found.first, r);
    found.second = std::max(found.second, r);
  }
  return found;
}

const double rim = sphere * std::asin(60.0 / sphere); // along the ball

TEST(RimOffset, ThePassKeepsInsideTheRim)
{
  for (const SpiralMethod method : {SpiralMethod::Radial, SpiralMethod::ConstantScallop}) {
    Generator generator = generatorOf(*bowl(0.0), 6000, method);
    generator.setRimOverhang(-5.0);
    Path path;
    generator.compute(path);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    EXPECT_NEAR(reach(path).second, rim - 5.0, 0.7); // the rim itself is known to a third of a spacing of 1.4 mm
    EXPECT_EQ(generator.getReport().gap_points, 0u);
  }
}

TEST(RimOffset, BeyondTheRimThePathRunsOnStraight)
{
  for (const SpiralMethod method : {SpiralMethod::Radial, SpiralMethod::ConstantScallop}) {
    Generator generator = generatorOf(*bowl(0.0), 6000, method);
    generator.setRimOverhang(4.0);
    Path path;
    generator.compute(path);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    const double angle = rim / sphere;
    std::size_t beyond = 0;
    for (const ToolpathPoint& p : path) {
      const double r = std::hypot(p.x, p.y) - sphere * std::sin(angle), z = p.z - sphere * std::cos(angle);
      const double out = r * std::cos(angle) - z * std::sin(angle), off = r * std::sin(angle) + z * std::cos(angle);
      ASSERT_LT(out, 4.0 + 0.7);
      if (out > 1.5) {
        ++beyond;
        EXPECT_NEAR(off, 0.0, 0.12); // from the cone that touches the ball at its rim
        EXPECT_EQ(p.over_gap, 1);
      }
    }
    EXPECT_GT(beyond, 300u);
    EXPECT_GT(reach(path).second, rim + 3.2);
  }
}

TEST(RimOffset, AnOverhangLongerThanThePartIsRefused)
{
  for (const double overhang : {200.0, 1e30}) {
    Generator generator = generatorOf(*bowl(0.0), 2000, SpiralMethod::Radial);
    generator.setRimOverhang(overhang);
    Path path;
    generator.compute(path);
    EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidArgument);
    EXPECT_NE(generator.getStatus().message().find("from end to end"), std::string::npos) << generator.getStatus().message();
    EXPECT_TRUE(path.empty());
  }
}

TEST(RimOffset, HolesKeepTheirMargin)
{
  Generator generator = generatorOf(*bowl(20.0), 6000, SpiralMethod::Radial);
  generator.setHoleMargin(3.0);
  Path path;
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidArgument);
  for (const SpiralMethod method : {SpiralMethod::ConstantScallop, SpiralMethod::Shortest}) { // the remedy
    generator.setMethod(method);
    generator.compute(path);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    EXPECT_EQ(generator.getReport().method, SpiralMethod::ConstantScallop);
    EXPECT_NEAR(reach(path).first, sphere * std::asin(20.0 / sphere) + 3.0, 0.7);
    EXPECT_NEAR(reach(path).second, rim, 0.7);
  }
}

TEST(RimOffset, CornersStaySharpInsideAndAreRoundBeyond)
{
  const SurfacePtr square = flat(Region({rectangle(80.0, 80.0)}));
  for (const double overhang : {-6.0, 6.0}) {
    Generator generator = generatorOf(*square, 5000, SpiralMethod::ConstantScallop);
    generator.setRimOverhang(overhang);
    Path path;
    generator.compute(path);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    const double corner = overhang < 0.0 ? (40.0 + overhang) * std::sqrt(2.0) : 40.0 * std::sqrt(2.0) + overhang;
    double farthest = 0.0, widest = 0.0;
    for (const ToolpathPoint& p : path) {
      farthest = std::max(farthest, (p.x + p.y) / std::sqrt(2.0));
      widest = std::max(widest, static_cast<double>(std::abs(p.x)));
    }
    EXPECT_NEAR(farthest, corner, 1.3); // a spacing, and a little
    EXPECT_NEAR(widest, 40.0 + overhang, 0.8);
  }
}

TEST(RimOffset, WhereThePartFallsIntoPiecesItIsRefusedWithThePlace)
{
  const PlaneLoop waist{{-40, -20}, {-6, -20}, {-6, -4}, {6, -4}, {6, -20}, {40, -20},
                        {40, 20},   {6, 20},   {6, 4},   {-6, 4}, {-6, 20}, {-40, 20}};
  Generator generator = generatorOf(*flat(Region({waist})), 5000, SpiralMethod::ConstantScallop);
  generator.setRimOverhang(-5.0);
  Path path;
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_NE(generator.getStatus().message().find("falls into pieces"), std::string::npos);
  EXPECT_TRUE(path.empty());
  generator.setRimOverhang(-25.0);
  generator.compute(path);
  EXPECT_NE(generator.getStatus().message().find("nothing is left"), std::string::npos);
  generator.setRimOverhang(-2.0); // the remedy
  generator.compute(path);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
}

TEST(RimOffset, AnInsetThatMeetsAHoleIsRefused)
{
  const SurfacePtr part = flat(Region({circle({0, 0}, 40.0), circle({22.0, 0.0}, 12.0)}));
  Generator generator = generatorOf(*part, 5000, SpiralMethod::ConstantScallop);
  generator.setRimOverhang(-8.0);
  Path path;
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_NE(generator.getStatus().message().find("setHoleMargin"), std::string::npos);
  generator.setHoleMargin(0.5); // the remedy: outlines that meet become one
  generator.compute(path);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
}

} // namespace

} // namespace rim_offset_test
