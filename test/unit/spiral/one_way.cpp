// SPDX-License-Identifier: BSD-3-Clause
// Paths at constant scallop height that cut in only one sense: direction of every move, material left, passes.
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/verify/material_removal.h>

#include "support/outlines.h"
#include "support/path_judge.h"
#include "support/sampling.h"
#include "support/test_machines.h"

#include <pcl/console/print.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace one_way_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

using Generator = SpiralToolpathGenerator<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

const double pitch = exactStepOver(5.0, 0.1, 0.0);

SpiralSettings
oneWay()
{
  SpiralSettings s;
  s.method = SpiralMethod::ConstantScallop;
  s.tool_radius = 5.0;
  s.scallop_height = 0.1;
  s.one_way = true;
  return s;
}

SurfacePtr
twoHoles()
{
  return flat(Region({rectangle(90.0, 60.0), circle({-20.0, 4.0}, 9.0), circle({21.0, -5.0}, 11.0)}));
}

SurfacePtr
ell()
{
  return flat(Region({{{0.0, 0.0}, {70.0, 0.0}, {70.0, 30.0}, {34.0, 30.0}, {34.0, 80.0}, {0.0, 80.0}}}));
}

struct Made {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;
  Path path;
  SpiralReport report;
};

Made
made(const AnalyticSurface& part, const SpiralSettings& settings, std::size_t points = 5000)
{
  Made result;
  result.cloud = toCloud(sampleUniform(part, points, 5).points);
  Generator generator;
  generator.setInputCloud(result.cloud);
  generator.setSettings(settings);
  generator.compute(result.path);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  result.report = generator.getReport();
  EXPECT_EQ(result.report.pass_begins, generator.getPassBegins());
  EXPECT_EQ(result.report.pass_begins, passBegins(result.path));
  return result;
}

/** Lengths cut with the distance from the rims increasing to the left of travel, and to the right; where the difference between the
 *  sides is at most \p beside, as along ridges, neither counts. */
struct SenseOfTravel {
  double left = 0.0, right = 0.0;
};

SenseOfTravel
senseOf(const AnalyticSurface& part, const Path& path, const std::vector<std::size_t>& begins)
{
  SenseOfTravel sense;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vector3d a = path[i - 1].getVector3fMap().cast<double>(), b = path[i].getVector3fMap().cast<double>();
    if (beginsPass(begins, i) || (b - a).norm() < 0.05)
      continue;
    const Vector3d middle = 0.5 * (a + b), left = 0.6 * pitch * Vector3d::UnitZ().cross(b - a).normalized();
    if (!part.contains(middle + left) || !part.contains(middle - left))
      continue;
    const double slope = (part.rimDistance(middle + left) - part.rimDistance(middle - left)) / (1.2 * pitch);
    if (std::abs(slope) > 0.8)
      (slope > 0.0 ? sense.left : sense.right) += (b - a).norm();
  }
  return sense;
}

JudgedReport
judged(const AnalyticSurface& part, const Made& made, double tool_radius = 5.0, double scallop_height = 0.1)
{
  JudgeSettings settings;
  settings.tool_radius = tool_radius;
  settings.scallop_height = scallop_height;
  settings.samples = 50000;
  settings.spacing = made.report.spacing;
  std::vector<Polyline> curves;
  for (const BoundaryLoop& loop : made.report.loops)
    curves.push_back(loop.curve);
  return judgedPath(part, curves, fromToolpath(made.path), settings);
}

class OneWay : public testing::Test {
protected:
  OneWay() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
};

} // namespace

TEST_F(OneWay, NothingIsCutAgainstTheSenseAndNoMoreIsLeft)
{
  SpiralSettings both = oneWay();
  both.one_way = false;
  for (const SurfacePtr& part : {twoHoles(), ell(), outlinedPart("dumbbell", 0, 0.6)}) {
    const Made two_way = made(*part, both), one_way = made(*part, oneWay());
    const SenseOfTravel before = senseOf(*part, two_way.path, {}), after = senseOf(*part, one_way.path, one_way.report.pass_begins);
    std::printf("  %.0f mm, %.0f against the sense; one way %.0f mm, %.0f against, %zu passes, %.0f mm of lifts\n",
                two_way.report.path_length, before.right, one_way.report.path_length, after.right, one_way.report.pass_begins.size() + 1,
                one_way.report.lift_length);
    if (two_way.report.reversed_share > 0.05) {
      EXPECT_GT(before.right, 0.02 * before.left); // the oracle detects the loops that bridges reverse
    }
    EXPECT_EQ(after.right, 0.0);
    EXPECT_GT(after.left, 0.6 * one_way.report.path_length);
    EXPECT_EQ(one_way.report.reversed_share, 0.0);
    EXPECT_EQ(one_way.report.bridges, 0u);
    EXPECT_TRUE(two_way.report.pass_begins.empty());
    EXPECT_FALSE(one_way.report.pass_begins.empty());
    EXPECT_LT(one_way.report.path_length, 1.03 * two_way.report.path_length);
    const JudgedReport f = judged(*part, one_way), g = judged(*part, two_way);
    EXPECT_TRUE(f.crossings.empty());
    EXPECT_TRUE(f.jumps.empty());
    EXPECT_EQ(f.inside.uncut_share, 0.0);
    EXPECT_LT(f.inside.p999.value, std::max(1.02, g.inside.p999.value + 0.01));
    EXPECT_LT(f.inside.over_share, g.inside.over_share + 5e-4);
  }
}

/** A pass that leaves the edge of a hole at its corner is moved far from the place where it covered everything. */
TEST_F(OneWay, PassesMovedFarUncoverNothing)
{
  const SurfacePtr part = flat(Region({rectangle(120.0, 30.0), rectangle(56.0, 10.0)}));
  for (const SpiralSense sense : {SpiralSense::CounterClockwise, SpiralSense::Clockwise}) {
    SpiralSettings settings = oneWay();
    settings.tool_radius = 4.0;
    settings.scallop_height = 0.07;
    settings.sense = sense;
    const JudgedReport f = judged(*part, made(*part, settings, 6500), 4.0, 0.07);
    EXPECT_LT(f.inside.max.value, 1.25);
    EXPECT_LT(f.inside.over_share, 2e-3);
    std::printf("  largest ridge %.3f h, %.3f %% over 1.05 h\n", f.inside.max.value, 100.0 * f.inside.over_share);
  }
}

TEST_F(OneWay, EveryPassGoesTheWayAskedFor)
{
  const SurfacePtr part = twoHoles();
  for (const SpiralDirection direction : {SpiralDirection::Inward, SpiralDirection::Outward})
    for (const SpiralSense turn : {SpiralSense::CounterClockwise, SpiralSense::Clockwise}) {
      SpiralSettings s = oneWay();
      s.direction = direction;
      s.sense = turn;
      const Made one_way = made(*part, s);
      SenseOfTravel sense = senseOf(*part, one_way.path, one_way.report.pass_begins);
      if (turn == SpiralSense::Clockwise)
        std::swap(sense.left, sense.right);
      EXPECT_EQ(sense.right, 0.0);
      const auto rim = [&](std::size_t i) { return part->rimDistance(one_way.path[i].getVector3fMap().cast<double>()); };
      double outermost = 1e30;
      for (const PassRange& pass : passRanges(one_way.report.pass_begins, one_way.path.size())) {
        const double begin = rim(pass.begin), end = rim(pass.end - 1);
        outermost = std::min(begin, end);
        if (std::abs(begin - end) > pitch) {
          EXPECT_EQ(begin < end, direction == SpiralDirection::Inward);
        }
      }
      if (direction == SpiralDirection::Outward) {
        EXPECT_LT(outermost, 0.5); // the pass of the rim comes last
      }
    }
}

TEST_F(OneWay, ADiscIsOnePassAndTheSameBytes)
{
  const SurfacePtr part = flat(Region({circle(Vector2d::Zero(), 40.0)}));
  SpiralSettings both = oneWay();
  both.one_way = false;
  const Made two_way = made(*part, both), one_way = made(*part, oneWay());
  EXPECT_TRUE(one_way.report.pass_begins.empty());
  ASSERT_EQ(one_way.path.size(), two_way.path.size());
  for (std::size_t i = 0; i < one_way.path.size(); ++i) {
    const ToolpathPoint &a = one_way.path[i], &b = two_way.path[i];
    ASSERT_EQ(a.getVector3fMap(), b.getVector3fMap());
    ASSERT_EQ(a.getNormalVector3fMap(), b.getNormalVector3fMap());
    ASSERT_EQ(a.getAxisVector3fMap(), b.getAxisVector3fMap());
    ASSERT_EQ(a.arc_length, b.arc_length);
    ASSERT_EQ(a.turn, b.turn);
  }
}

TEST_F(OneWay, AxesOfAPassDoNotKnowTheOthers)
{
  SpiralSettings s = oneWay();
  s.axis_smoothing = 0.0; // then on a plane all axes have the same tilt, to the right of travel
  s.max_axis_rate = 1e6;
  const Made one_way = made(*twoHoles(), s);
  for (const PassRange& pass : passRanges(one_way.report.pass_begins, one_way.path.size()))
    for (const std::size_t i : {pass.begin, pass.end - 1}) {
      const std::size_t a = i == pass.begin ? i : i - 1;
      const Vector3d along = (one_way.path[a + 1].getVector3fMap() - one_way.path[a].getVector3fMap()).cast<double>().normalized();
      const Vector3d axis = one_way.path[i].getAxisVector3fMap().cast<double>();
      EXPECT_NEAR(axis.dot(along.cross(Vector3d::UnitZ())), std::sin(15.0 * M_PI / 180.0), 0.05) << i;
    }
}

TEST_F(OneWay, TheJudgeTakesNoLiftForACut)
{
  const SurfacePtr part = twoHoles();
  const Made one_way = made(*part, oneWay());
  const auto path = pcl::make_shared<Path>(one_way.path);
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(one_way.cloud);
  removal.setInputToolpath(path);
  removal.setToolRadius(5.0);
  removal.setScallopHeight(0.1);
  pcl::PointCloud<pcl::PointXYZI> heights;
  removal.compute(heights);
  ASSERT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  EXPECT_NEAR(removal.getReport().path_length, one_way.report.path_length, 0.1);
  EXPECT_EQ(removal.getReport().stock.uncut, 0u);
  CutterPath cut;
  ASSERT_TRUE(readCutterPath(path, cut).ok());
  EXPECT_LT(pathMotion(cut).gap.value, 5.3);
  const BallSweep ball(cut.contacts, cut.normals, 5.0, cut.passes);
  const std::size_t lift = cut.passes.front() - 1;
  const Vector3d middle = 0.5 * (ball.centres()[lift] + ball.centres()[lift + 1]);
  EXPECT_FALSE(ball.contains(lift, middle));
  EXPECT_TRUE(BallSweep(cut.contacts, cut.normals, 5.0).contains(lift, middle));
}

/** Arc lengths rounded to 20 mm do not change at most moves: these cuts would look like lifts. */
TEST_F(OneWay, RoundedArcLengthsAreNoLifts)
{
  const auto path = pcl::make_shared<Path>(made(*ell(), oneWay()).path);
  CutterPath cut;
  for (ToolpathPoint& p : *path)
    p.arc_length = std::round(100.0 * p.arc_length) / 100.0;
  EXPECT_TRUE(readCutterPath(path, cut).ok());
  for (ToolpathPoint& p : *path)
    p.arc_length = 20.0 * std::round(p.arc_length / 20.0);
  const Status status = readCutterPath(path, cut);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message().find("arc lengths"), std::string::npos) << status.message();
  for (ToolpathPoint& p : *path)
    p.arc_length = 0.0;
  EXPECT_TRUE(readCutterPath(path, cut).ok()) << "without arc lengths all is one pass";
}

TEST_F(OneWay, ProgramsLiftTheToolBetweenPasses)
{
  const Made one_way = made(*twoHoles(), oneWay());
  MachineProgramGenerator generator;
  generator.setMachine(testMachines()[2]);
  generator.setInputPath(one_way.path, 5.0);
  MachineProgram program;
  generator.compute(program);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  std::size_t cuts = 0, retracts = 0;
  for (std::size_t i = 0; i < program.blocks.size(); ++i) {
    const auto begins = [&](BlockSection section) {
      return program.blocks[i].section == section && (i == 0 || program.blocks[i - 1].section != section);
    };
    cuts += begins(BlockSection::Cut);
    retracts += begins(BlockSection::Retract);
  }
  EXPECT_EQ(cuts, one_way.report.pass_begins.size() + 1);
  EXPECT_EQ(retracts, cuts);
}

} // namespace one_way_test
