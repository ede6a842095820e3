// SPDX-License-Identifier: BSD-3-Clause
// Radial lines given by the user: unsuitable lines are refused, and the noise of the scan is reported as always.
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace given_lines_test {

namespace {

using namespace pcl_spiral;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Part {
  Surface::ConstPtr surface;
  RadialLineSet lines;
};

Part
dome(double noise)
{
  auto sampled = test::sampleUniform(*test::spheroidCap(80.0, 45.0), 12000, 1);
  test::addNoise(sampled, noise, 2);
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(test::toCloud(sampled.points));
  Part part;
  scanned.compute(part.surface);
  RadialLines<pcl::PointXYZ> radial;
  radial.setInputSurface(part.surface);
  radial.compute(part.lines);
  EXPECT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();
  return part;
}

SpiralToolpathGenerator<pcl::PointXYZ>
generatorOn(const Part& part)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.1);
  spiral.setQuiet(true);
  spiral.setInputSurface(part.surface);
  return spiral;
}

TEST(GivenLines, ThatCannotBeDrawnOnAreRefused)
{
  const Part part = dome(0.0);
  auto spiral = generatorOn(part);
  Path path;
  spiral.setRadialLines(part.lines);
  spiral.compute(path);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  const auto refused = [&](const std::string& word, const std::function<void(RadialLineSet&)>& change) {
    RadialLineSet wrong = part.lines;
    change(wrong);
    spiral.setRadialLines(wrong);
    spiral.compute(path);
    EXPECT_EQ(spiral.getStatus().code(), StatusCode::InvalidInput) << word;
    EXPECT_NE(spiral.getStatus().message().find(word), std::string::npos) << spiral.getStatus().message();
    EXPECT_TRUE(path.empty());
  };
  refused("point 5 of the rim", [](RadialLineSet& set) { set.rim[5].setConstant(nan); });
  refused("inner boundary of the radial lines has 1 points", [](RadialLineSet& set) { set.inner = {set.lines[0].feet[0].position}; });
  refused("point 1 of the inner boundary", [](RadialLineSet& set) {
    set.inner = {set.lines[0].feet[0].position, Eigen::Vector3d::Constant(nan), set.lines[2].feet[0].position};
  });
  refused("line 3: foot 20 is not finite", [](RadialLineSet& set) { set.lines[3].feet[20].curvature1 = nan; });
  refused("line 3: foot 20 is not finite",
          [](RadialLineSet& set) { set.lines[3].feet[20].curvature2 = std::numeric_limits<double>::infinity(); });
  refused("line 3: foot 20 is not finite", [](RadialLineSet& set) { set.lines[3].feet[20].direction1.x() = nan; });
  refused("line 2 has the level -1", [](RadialLineSet& set) { set.lines[2].level = -1; });
  refused("line 2 has the level 2147483647", [](RadialLineSet& set) { set.lines[2].level = std::numeric_limits<int>::max(); });
  refused("clockwise along the rim", [](RadialLineSet& set) { // an earlier fault: a path in the opposite sense
    std::reverse(set.lines.begin() + 1, set.lines.end());
    std::reverse(set.rim.begin() + 1, set.rim.end());
    for (std::size_t i = 1; i < set.lines.size(); ++i) {
      set.lines[i].rim_share = 1.0 - set.lines[i].rim_share;
      set.lines[i].turn_share = 1.0 - set.lines[i].turn_share;
    }
  });
  refused("level 0", [](RadialLineSet& set) { // an earlier fault: an endless run without a message
    for (RadialLine& line : set.lines)
      line.level = 1;
  });
}

TEST(GivenLines, NoiseIsReportedAsWithoutThem)
{
  const Part part = dome(0.05);
  for (const bool given : {false, true}) {
    auto spiral = generatorOn(part);
    spiral.setScallopHeight(0.02);
    if (given)
      spiral.setRadialLines(part.lines);
    Path path;
    spiral.compute(path);
    const pcl_spiral::Diagnostics& warnings = spiral.getReport().warnings;
    EXPECT_EQ(
        std::count_if(warnings.begin(), warnings.end(),
                      [](const pcl_spiral::Diagnostic& w) { return w.text().find("is below the noise of the scan") != std::string::npos; }),
        1)
        << given;
  }
}

} // namespace

} // namespace given_lines_test
