// SPDX-License-Identifier: BSD-3-Clause
// Settings of ScannedSurface in every stage that works on a surface: the remedies of messages, and settings that are refused
// with a given surface.
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/surface/mls_projector.h>
#include <pcl_spiral/verify/material_removal.h>

#include <pcl/surface/mls.h>

#include <gtest/gtest.h>
#include <pcl/console/print.h>

#include <cmath>
#include <random>
#include <regex>

namespace surface_input_test {

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Loops = BoundaryLoops<pcl::PointXYZ>;

namespace {

/** A square of 100 mm about (\p x, 0, 0), with points that have noise along z. */
void
addSquare(Cloud& cloud, std::size_t count, double x, double noise, double side = 50.0)
{
  std::mt19937 random(1);
  std::normal_distribution<double> off(0.0, 1.0);
  std::uniform_real_distribution<double> along(-side, side);
  for (std::size_t i = 0; i < count; ++i) {
    const double u = along(random), v = along(random);
    cloud.emplace_back(static_cast<float>(x + u), static_cast<float>(v), static_cast<float>(noise * off(random)));
  }
}

Cloud::Ptr
square(std::size_t count, double noise)
{
  Cloud::Ptr cloud(new Cloud);
  addSquare(*cloud, count, 0.0, noise);
  return cloud;
}

Status
outcome(Loops& loops, std::size_t* found = nullptr)
{
  std::vector<BoundaryLoop> result;
  loops.setQuiet(true);
  loops.compute(result);
  if (found)
    *found = result.size();
  return loops.getStatus();
}

template <typename Stage>
void
expectSettings()
{
  Stage stage;
  stage.setThinning(2.5);
  stage.setOutlierRemoval(16, 4.0);
  stage.setLargestPart(true);
  EXPECT_EQ(stage.getThinning(), 2.5);
  EXPECT_EQ(stage.getOutlierNeighbours(), 16);
  EXPECT_EQ(stage.getOutlierDeviations(), 4.0);
  EXPECT_TRUE(stage.getLargestPart());
}

} // namespace

TEST(SurfaceInput, SmoothingIsWhatTheMessageSays)
{
  const Cloud::Ptr noisy = square(10000, 0.39), smooth(new Cloud); // points about 1 mm apart
  Loops loops;
  loops.setInputCloud(noisy);
  const std::string message = outcome(loops).message();
  std::smatch radius;
  ASSERT_TRUE(std::regex_search(message, radius, std::regex("-radius ([0-9.]+)"))) << message;
  pcl::MovingLeastSquares<Cloud::PointType, Cloud::PointType> fit;
  fit.setInputCloud(noisy);
  fit.setSearchRadius(std::stod(radius[1]));
  fit.process(*smooth);
  loops.setInputCloud(smooth);
  std::size_t found = 0;
  const Status smoothed = outcome(loops, &found);
  EXPECT_TRUE(smoothed.ok()) << smoothed.message();
  EXPECT_EQ(found, 1u);
}

TEST(SurfaceInput, NoSmoothingIsNamedForMoreScatterThanFoldsHave)
{
  Loops loops;
  loops.setInputCloud(square(10000, 1.5));
  const std::string message = outcome(loops).message();
  EXPECT_NE(message.find("cannot be told from folds of the part with too few points"), std::string::npos) << message;
  EXPECT_EQ(message.find("-radius"), std::string::npos) << message;
}

TEST(SurfaceInput, TheLargestPartIsKeptAsTheMessageSays)
{
  const Cloud::Ptr cloud = square(6000, 0.0);
  addSquare(*cloud, 3000, 150.0, 0.0, 30.0);
  Loops loops;
  loops.setInputCloud(cloud);
  EXPECT_NE(outcome(loops).message().find("setLargestPart"), std::string::npos) << loops.getStatus().message();
  loops.setLargestPart(true);
  std::size_t found = 0;
  EXPECT_TRUE(outcome(loops, &found).ok()) << loops.getStatus().message();
  EXPECT_EQ(found, 1u);
}

TEST(SurfaceInput, EveryStageHasTheSettings)
{
  expectSettings<Loops>();
  expectSettings<GapBridging<pcl::PointXYZ>>();
  expectSettings<RadialLines<pcl::PointXYZ>>();
  expectSettings<MLSProjector<pcl::PointXYZ, pcl::PointNormal>>();
  expectSettings<CutterLocation<pcl::PointXYZ>>();
  expectSettings<DrivePath<pcl::PointXYZ>>();
  expectSettings<MaterialRemoval<pcl::PointXYZ>>();
}

TEST(SurfaceInput, SettingsThatContradictAGivenSurfaceAreRefused)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(square(6000, 0.0));
  Surface::ConstPtr surface;
  scanned.compute(surface);
  ASSERT_TRUE(surface);
  const auto refused = [&](const char* setter, auto change) {
    Loops loops;
    loops.setInputSurface(surface);
    change(loops);
    EXPECT_EQ(outcome(loops).code(), StatusCode::InvalidArgument);
    EXPECT_NE(loops.getStatus().message().find(setter), std::string::npos) << loops.getStatus().message();
  };
  refused("setThinning", [](Loops& l) { l.setThinning(2.0); });
  refused("setOutlierRemoval", [](Loops& l) { l.setOutlierRemoval(16); });
  refused("setLargestPart", [](Loops& l) { l.setLargestPart(true); });
}

TEST(SurfaceInput, NormalsBesideASurfaceAndTheRemedy)
{
  const Cloud::Ptr cloud = square(6000, 0.0);
  const pcl::PointCloud<pcl::Normal>::Ptr up(new pcl::PointCloud<pcl::Normal>(6000, 1, pcl::Normal(0.0f, 0.0f, 1.0f)));
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  scanned.setInputNormals(up);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  Loops loops;
  loops.setInputNormals(up);
  loops.setInputSurface(surface);
  EXPECT_EQ(outcome(loops).code(), StatusCode::InvalidArgument);
  EXPECT_NE(loops.getStatus().message().find("call setInputNormals with a null pointer"), std::string::npos) << loops.getStatus().message();
  loops.setInputNormals(nullptr);
  EXPECT_TRUE(outcome(loops).ok()) << loops.getStatus().message();
}

} // namespace surface_input_test
