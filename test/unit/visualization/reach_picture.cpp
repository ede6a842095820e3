// SPDX-License-Identifier: BSD-3-Clause
// The picture of the largest balls: a groove planted in a plate is seen at its place in the colour of its radius, and nothing else is.
#include <pcl_spiral/visualization/reach_picture.h>

#include "support/picture_pixels.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace reach_picture_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr int map_end = 1170;                      // column of pixels: the plate is left of it
constexpr double half = 50.0, groove_width = 10.0; // mm
constexpr float tight = 2.0f, largest = 20.0f;     // mm

/** A plate whose points reach \p largest, but for a groove along y in its middle. */
ReachScene
plate()
{
  ReachScene scene;
  scene.part.title = "plate";
  scene.part.settings.tool_radius = 5.0;
  scene.largest = largest;
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (double x = -half; x <= half; ++x)
    for (double y = -half; y <= half; ++y) {
      cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), 0.0f);
      scene.radii.push_back(std::abs(x) < 0.5 * groove_width ? tight : largest);
    }
  auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  for (int i = 0; i <= 40; ++i) {
    ToolpathPoint point;
    point.getVector3fMap() = Eigen::Vector3d((i % 2 == 0 ? -half : half), -half + 2.5 * i, 0.0).cast<float>();
    point.getNormalVector3fMap() = Eigen::Vector3f::UnitZ();
    point.arc_length = 100.0 * i;
    path->push_back(point);
  }
  scene.part.cloud = cloud;
  scene.part.path = path;
  return scene;
}

bool
isTight(const Pixel& p) // the dark end of the scale, not the ink of words
{
  return p[2] > p[1] + 60 && p[0] > 50 && p[0] < 90;
}

bool
isWide(const Pixel& p) // its bright end
{
  return p[1] > 180 && p[0] > 140 && p[2] < 60;
}

} // namespace

TEST(ReachPicture, AGrooveIsSeenAtItsPlaceInItsColour)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  const ReachScene scene = plate();
  writeReach(folder.path("a.png"), scene);
  const auto image = readPicture(folder.path("a.png"));
  double groove = 0.0, beside = 0.0, middle = 0.0, all = 0.0;
  for (int y = 0; y < 1200; ++y)
    for (int x = 0; x < map_end; ++x) {
      const Pixel pixel = at(image, x, y);
      groove += isTight(pixel);
      middle += isTight(pixel) ? x : 0.0;
      beside += isWide(pixel);
      all += isWide(pixel) ? x : 0.0;
    }
  EXPECT_NEAR(groove / (groove + beside), groove_width / (2.0 * half), 0.02);
  EXPECT_NEAR(middle / groove, all / beside, 5.0) << "in the middle of the plate";
  EXPECT_GT(groove + beside, 200000.0) << "the plate is covered";
}

TEST(ReachPicture, RadiiThatAreNotOnePerPointAreRefused)
{
  ReachScene scene = plate();
  scene.radii.pop_back();
  EXPECT_THROW(writeReach("none.png", scene), std::invalid_argument);
  scene.part.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  EXPECT_THROW(writeReach("none.png", scene), std::invalid_argument);
}

} // namespace reach_picture_test
