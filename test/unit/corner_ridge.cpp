// The ridge foretold at corners, against the material that moves of a ball leave on the exact plate.
#include "support/removed_material.h"
#include "support/sampling.h"

#include <pcl_spiral/toolpath/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace pcl_spiral;

constexpr double height = 0.02, chord_error = 0.001;

struct Made {
  pcl::PointCloud<ToolpathPoint> path;
  SpiralReport report;
};

Made
spiralOn(const test::SurfacePtr& plate)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(test::toCloud(test::sampleUniform(*plate, 20000, 3).points));
  spiral.setToolRadius(5.0);
  spiral.setScallopHeight(height);
  spiral.setChordError(chord_error);
  Made made;
  spiral.compute(made.path);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  made.report = spiral.getReport();
  return made;
}

double
highestRidge(const test::SurfacePtr& plate, const Made& made)
{
  test::RemovalSettings settings;
  settings.tool_radius = 5.0;
  settings.scallop_height = height;
  settings.samples = 40000;
  return test::removedMaterial(*plate, test::fromToolpath(made.path), settings).ridge.max.value;
}

bool
warnsOfCorners(const SpiralReport& report)
{
  for (const std::string& warning : report.warnings)
    if (warning.find("at corners of the outline") != std::string::npos)
      return true;
  return false;
}

class Polygons : public testing::TestWithParam<int> {};

TEST_P(Polygons, LeaveTheRidgeForetold)
{
  const test::SurfacePtr plate = test::flat(test::Region({test::circle({0, 0}, 45.0, GetParam())}));
  const Made made = spiralOn(plate);
  // Sides l apart, half angle alpha: the ridge is that of turns 2 l / (1 + sin alpha) apart.
  const double sine = std::cos(M_PI / GetParam()), most = 4.0 * height / std::pow(1.0 + sine, 2);
  EXPECT_LT(made.report.corner_ridge, 1.01 * most);
  EXPECT_NEAR(made.report.corner_ridge, highestRidge(plate, made), 0.06 * most + chord_error);
  EXPECT_EQ(made.report.loops.front().corners.size(), static_cast<std::size_t>(GetParam()));
  EXPECT_EQ(warnsOfCorners(made.report), made.report.corner_ridge > 1.05 * height);
}

INSTANTIATE_TEST_SUITE_P(CornerRidge, Polygons, testing::Values(3, 4, 5, 6));

TEST(CornerRidge, OfAnOutlineWithoutCornersIsNone)
{
  const test::SurfacePtr disc = test::flat(test::Region({test::circle({0, 0}, 45.0)}));
  const Made made = spiralOn(disc);
  EXPECT_EQ(made.report.corner_ridge, 0.0);
  EXPECT_FALSE(warnsOfCorners(made.report));
  EXPECT_LT(highestRidge(disc, made), 1.03 * height + chord_error);
}

} // namespace
