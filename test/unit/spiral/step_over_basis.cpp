// SPDX-License-Identifier: BSD-3-Clause
// A field, loops and a linked path know the tool radius and scallop height that they were made with, and refuse others.
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace step_over_basis_test {

namespace {

using namespace pcl_spiral;
using P = pcl::PointXYZ;

/** A scan of a saddle, 50 mm across. */
Surface::ConstPtr
saddle()
{
  const pcl::PointCloud<P>::Ptr cloud(new pcl::PointCloud<P>);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-25.0, 25.0);
  while (cloud->size() < 5000) {
    const double x = any(random), y = any(random);
    if (std::hypot(x, y) < 25.0)
      cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(0.004 * (x * x - y * y)));
  }
  ScannedSurface<P> scanned;
  scanned.setInputCloud(cloud);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  return surface;
}

template <typename Stage>
void
refuses(const Stage& stage, const std::string& made, const std::string& used, const std::string& setter)
{
  EXPECT_EQ(stage.getStatus().code(), StatusCode::InvalidArgument);
  for (const std::string& part : {made + " mm", used + " mm", setter})
    EXPECT_NE(stage.getStatus().message().find(part), std::string::npos) << part << " in: " << stage.getStatus().message();
}

class StepOverBasisTest : public testing::Test {
protected:
  void SetUp() override
  {
    surface_ = saddle();
    ASSERT_TRUE(surface_);
    StepOverField<P> maker;
    maker.setInputSurface(surface_);
    maker.setToolRadius(5.0);
    maker.setScallopHeight(0.1);
    maker.compute(field_);
    ASSERT_TRUE(field_) << maker.getStatus().message();
  }

  Surface::ConstPtr surface_;
  StepOverDistance::ConstPtr field_;
};

} // namespace

TEST_F(StepOverBasisTest, AFieldRefusesOthers)
{
  LoopLinking<P> linking;
  linking.setInputField(field_);
  LinkedPath path;
  linking.setToolRadius(1.0);
  linking.compute(path);
  refuses(linking, "5", "1", "setToolRadius");
  EXPECT_TRUE(path.points.empty());
  linking.setToolRadius(5.0);
  linking.setScallopHeight(0.01);
  linking.compute(path);
  refuses(linking, "0.1", "0.01", "setScallopHeight");
  linking.setScallopHeight(0.1);
  linking.compute(path);
  EXPECT_TRUE(linking.getStatus().ok()) << linking.getStatus().message();
  ScallopLoops<P> loops;
  loops.setInputField(field_);
  loops.setToolRadius(4.0);
  ScallopLoopSet set;
  loops.compute(set);
  refuses(loops, "5", "4", "setToolRadius");
}

TEST_F(StepOverBasisTest, LoopsAndAPathRefuseOthers)
{
  ScallopLoops<P> maker;
  maker.setInputField(field_);
  ScallopLoopSet set;
  maker.compute(set);
  ASSERT_TRUE(maker.getStatus().ok()) << maker.getStatus().message();
  LoopLinking<P> linking;
  linking.setInputLoops(set.loops);
  linking.setToolRadius(6.0);
  LinkedPath path;
  linking.compute(path);
  refuses(linking, "5", "6", "setToolRadius");
  linking.setToolRadius(5.0);
  linking.compute(path);
  ASSERT_TRUE(linking.getStatus().ok()) << linking.getStatus().message();
  EXPECT_EQ(path.basis.tool_radius, 5.0);
  EXPECT_EQ(path.basis.scallop_height, 0.1);
  SpiralSettings settings;
  settings.tool_radius = 5.0;
  settings.scallop_height = 0.2;
  std::vector<SpiralPoint> points;
  double longest = 0.0;
  const Status other = samplePath(path, *surface_, settings, points, longest);
  EXPECT_EQ(other.code(), StatusCode::InvalidArgument);
  EXPECT_TRUE(points.empty());
  settings.scallop_height = 0.1;
  EXPECT_TRUE(samplePath(path, *surface_, settings, points, longest).ok());
  EXPECT_FALSE(points.empty());
  DrivePasses passes;
  settings.scallop_height = 0.3;
  EXPECT_EQ(putLoopsOnSurface(set.loops, *surface_, settings, {}, passes).code(), StatusCode::InvalidArgument);
  EXPECT_TRUE(passes.empty());
}

TEST_F(StepOverBasisTest, WhatAFailedStageLeftIsRefused)
{
  SpiralSettings settings;
  settings.tool_radius = 5.0;
  settings.scallop_height = 0.1;
  LinkedPath linked;
  std::vector<SpiralPoint> curve;
  double longest = 0.0;
  SpiralPath path;
  GapReport gaps;
  AxisReport axes;
  ToolpathReport figures;
  pcl_spiral::Diagnostics warnings;
  for (const Status& status : {linkLoops({}, linked), samplePath(linked, *surface_, settings, curve, longest),
                               putOnSurface(curve, *surface_, settings, 1.0, {}, path, gaps), setToolAxes(settings, path, axes, warnings),
                               checkPath(path, settings, 1.0, {}, figures)})
    EXPECT_EQ(status.code(), StatusCode::InvalidInput) << status.message();
}

TEST_F(StepOverBasisTest, MixedLoopsAreRefusedAndTheUsersOwnAreNot)
{
  ScallopLoops<P> maker;
  maker.setInputField(field_);
  ScallopLoopSet set;
  maker.compute(set);
  ASSERT_GT(set.loops.size(), 2u);
  std::vector<ScallopLoop> mixed = set.loops;
  mixed[1].basis.scallop_height = 0.07;
  LoopLinking<P> linking;
  linking.setInputLoops(mixed);
  LinkedPath path;
  linking.compute(path);
  refuses(linking, "0.07", "0.1", "setScallopHeight");
  for (ScallopLoop& loop : mixed)
    loop.basis = StepOverBasis(); // not known
  linking.setInputLoops(mixed);
  linking.setToolRadius(1.0);
  linking.compute(path);
  EXPECT_TRUE(linking.getStatus().ok()) << linking.getStatus().message();
}

} // namespace step_over_basis_test
