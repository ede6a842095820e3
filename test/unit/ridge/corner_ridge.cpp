// SPDX-License-Identifier: BSD-3-Clause
// Predicted ridges at corners, and the remedy, against the material that moves of a ball leave on the exact plate.
#include "support/removed_material.h"
#include "support/sampling.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace corner_ridge_test {

namespace {

using namespace pcl_spiral;

constexpr double radius = 5.0, height = 0.02, chord_error = 0.001;

struct Made {
  pcl::PointCloud<ToolpathPoint> path;
  SpiralReport report;
};

Made
spiralOn(const test::SurfacePtr& plate, double scallop_height, const std::optional<Eigen::Vector3d>& centre = {})
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(test::toCloud(test::sampleUniform(*plate, 20000, 3).points));
  spiral.setMethod(SpiralMethod::Radial);
  spiral.setToolRadius(radius);
  spiral.setScallopHeight(scallop_height);
  spiral.setChordError(chord_error);
  if (centre)
    spiral.setCenter(*centre);
  Made made;
  spiral.compute(made.path);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  made.report = spiral.getReport();
  return made;
}

double
highestRidge(const test::SurfacePtr& plate, const Made& made, double scallop_height)
{
  test::RemovalSettings settings;
  settings.tool_radius = radius;
  settings.scallop_height = scallop_height;
  settings.samples = 40000;
  return test::removedMaterial(*plate, test::fromToolpath(made.path), settings).ridge.max.value;
}

/** The scallop height that a warning of corners advises; 0 if there is no warning. */
double
remedyOf(const SpiralReport& report)
{
  const std::string before = "with a scallop height of ";
  for (const pcl_spiral::Diagnostic& warning : report.warnings)
    if (const std::size_t at = warning.text().find(before); at != std::string::npos)
      return std::strtod(warning.text().c_str() + at + before.size(), nullptr);
  return 0.0;
}

test::SurfacePtr
polygon(int corners, double size = 45.0)
{
  return test::flat(test::Region({test::circle({0, 0}, size, static_cast<std::size_t>(corners))}));
}

/** The predicted height is left, if turns do not leave more; a warning reports it, and its remedy helps. */
void
expectForetold(const std::string& what, const test::SurfacePtr& plate, const std::optional<Eigen::Vector3d>& centre = {})
{
  SCOPED_TRACE(what);
  const Made made = spiralOn(plate, height, centre);
  const double highest = highestRidge(plate, made, height);
  EXPECT_NEAR(std::max(height, made.report.corner_ridge), highest, 0.06 * height + chord_error);
  const double remedy = remedyOf(made.report);
  EXPECT_EQ(remedy > 0.0, made.report.corner_ridge > 1.05 * height);
  if (remedy > 0.0) {
    EXPECT_LT(highestRidge(plate, spiralOn(plate, remedy, centre), height), 1.03 * height + chord_error);
  }
}

TEST(CornerRidge, OfRegularPolygons)
{
  for (const int corners : {3, 4, 5, 6}) {
    expectForetold(std::to_string(corners) + " corners", polygon(corners));
    // Sides l apart, half angle alpha: the height of turns 2 l / (1 + sin alpha) apart.
    const double sine = std::cos(M_PI / corners), most = 4.0 * height / std::pow(1.0 + sine, 2);
    const SpiralReport report = spiralOn(polygon(corners), height).report;
    EXPECT_LT(report.corner_ridge, 1.01 * most);
    EXPECT_EQ(report.loops.front().corners.size(), static_cast<std::size_t>(corners));
  }
}

TEST(CornerRidge, WhereLinesMeetSidesUnevenly)
{
  const test::SurfacePtr square = polygon(4);
  expectForetold("square, centre aside", square, Eigen::Vector3d(8.0, 3.0, 0.0));
  expectForetold("square, centre towards a corner", square, Eigen::Vector3d(20.0, 0.0, 0.0));
  expectForetold("oblong", test::flat(test::Region({test::rectangle(100.0, 50.0)})));
  expectForetold("right triangle", test::flat(test::Region({test::PlaneLoop{{-45, -20}, {45, -20}, {-45, 30}}})));
}

TEST(CornerRidge, WhereMaterialIsLeftUncut)
{
  const double high = 3.0; // turns nearly as far apart as the ball is wide
  const test::SurfacePtr plate = polygon(3, 200.0);
  const Made made = spiralOn(plate, high);
  EXPECT_EQ(made.report.corner_ridge, radius);
  EXPECT_GT(highestRidge(plate, made, high), radius);
  const double remedy = remedyOf(made.report);
  ASSERT_GT(remedy, 0.0);
  EXPECT_LT(highestRidge(plate, spiralOn(plate, remedy), high), 1.03 * high);
}

TEST(CornerRidge, OfAnOutlineWithoutCornersIsNone)
{
  const test::SurfacePtr disc = test::flat(test::Region({test::circle({0, 0}, 45.0)}));
  const Made made = spiralOn(disc, height);
  EXPECT_EQ(made.report.corner_ridge, 0.0);
  EXPECT_EQ(remedyOf(made.report), 0.0);
  EXPECT_LT(highestRidge(disc, made, height), 1.03 * height + chord_error);
}

} // namespace

} // namespace corner_ridge_test
