// SPDX-License-Identifier: BSD-3-Clause
// A judged path and a judged program in time: the tool is at each point of the path when the times say so.
#include "planning/playback.h"
#include "planning/way_times.h"
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/planning/program_planner.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include "support/scratch_folder.h"
#include "support/spiral_jobs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace playback_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double R = 3.0;

/** A spiral over a dome, planned once. */
const Spiral&
spiral()
{
  static Spiral* const made = [] {
    auto* const one = new Spiral;
    one->setInputCloud(dome());
    one->setToolRadius(R);
    one->setScallopHeight(0.02);
    one->compute();
    EXPECT_TRUE(one->getStatus().ok()) << one->getStatus().message();
    return one;
  }();
  return *made;
}

/** What the judge finds. */
struct Judged {
  PathJudge judge;
  JudgedPath path;
};

void
judge(const GivenPath& given, Judged& judged)
{
  JudgedInput input;
  input.cloud = dome();
  input.settings.cutter = CutterShape::ball(R);
  input.settings.scallop_height = 0.02;
  ASSERT_TRUE(judged.judge.prepare(input, 0.0).ok());
  const Status status = judged.judge.judge(given, 0, judged.path);
  ASSERT_TRUE(status.ok()) << status.message();
}

PlaybackInput
inputOf(const Judged& judged)
{
  PlaybackInput input;
  input.path = judged.path.path;
  input.tips = judged.path.tips;
  input.cutter = CutterShape::ball(R);
  input.machine = xyzacTrunnion();
  input.control = controlModel(ControlKind::LinuxCNC, input.machine);
  return input;
}

/** The centre of the ball is at the contact plus R normal when the times say so, within \p tolerance. */
void
expectOnThePath(const PlaybackInput& input, const PlaybackTime& time, double tolerance)
{
  ASSERT_EQ(time.reached.size(), input.path->size());
  EXPECT_TRUE(std::is_sorted(time.reached.begin(), time.reached.end()));
  EXPECT_LE(time.reached.back(), time.track.seconds());
  for (std::size_t i = 0; i < input.path->size(); ++i) {
    const ToolpathPoint& point = (*input.path)[i];
    const Eigen::Vector3d centre = (point.getVector3fMap() + static_cast<float>(R) * point.getNormalVector3fMap()).cast<double>();
    const MotionFrame frame = time.track.at(time.reached[i]);
    ASSERT_LT((frame.tip + R * frame.axis - centre).norm(), tolerance) << "point " << i << " block " << frame.block;
    ASSERT_EQ(movesAfter(time, time.reached[i]), [&] {
      std::size_t last = i;
      while (last + 1 < time.reached.size() && time.reached[last + 1] == time.reached[i])
        ++last;
      return last;
    }());
  }
}

} // namespace

TEST(Playback, APathIsPlayedAsTheProgramThatIsMadeOfIt)
{
  GivenPath given;
  given.path = spiral().getPlan().path;
  Judged judged;
  judge(given, judged);
  PlaybackInput input = inputOf(judged);
  PlaybackTime time;
  const Status status = playbackTime(input, time);
  ASSERT_TRUE(status.ok()) << status.message();
  expectOnThePath(input, time, 0.004);
  EXPECT_TRUE(time.lines.empty());
}

TEST(Playback, EveryPassOfAPathIsPlayed)
{
  PlaybackInput input;
  const pcl::PointCloud<ToolpathPoint>& whole = *spiral().getPlan().path;
  pcl::PointCloud<ToolpathPoint>::Ptr path(new pcl::PointCloud<ToolpathPoint>);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (i % 400 > 360)
      continue; // a way from pass to pass
    path->push_back(whole[i]);
    if (path->size() > 1) {
      const ToolpathPoint& before = (*path)[path->size() - 2];
      const double step = (whole[i].getVector3fMap() - before.getVector3fMap()).cast<double>().norm();
      path->back().arc_length = before.arc_length + (i % 400 == 0 ? 0.0 : step);
    }
  }
  ASSERT_GT(passBegins(*path).size(), 4U);
  input.path = path;
  input.cutter = CutterShape::ball(R);
  input.machine = xyzacTrunnion();
  input.control = controlModel(ControlKind::LinuxCNC, input.machine);
  PlaybackTime time;
  const Status status = playbackTime(input, time);
  ASSERT_TRUE(status.ok()) << status.message();
  expectOnThePath(input, time, 0.004);
}

TEST(Playback, TheEndOfAPassIsReachedOnTheSurface)
{
  std::vector<ToolPoses> passes(2);
  for (int pass = 0; pass < 2; ++pass)
    for (int i = 0; i < 2000; ++i) { // far from zero, so that single precision changes the length of each move
      ToolPose pose;
      pose.contact = Eigen::Vector3d(7031.37 + 0.0137 * i, 911.13 + 5.0 * pass + 0.3 * std::sin(0.01 * i), 3.0);
      pose.tip = pose.contact;
      passes[pass].push_back(pose);
    }
  MachineProgramGenerator generator;
  generator.setMachine(xyzacTrunnion());
  generator.setInputPasses(passes);
  MachineProgram program;
  generator.compute(program);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  MotionTime even; // a second each
  even.blocks.assign(program.blocks.size(), 1.0);
  const MotionTrack track(program, even);
  const PassPath joined = joinedPasses(passes);
  const std::vector<double> times = timesOnWay(joined.path, joined.begins, program.blocks, track.ends());
  ASSERT_EQ(times.size(), joined.path.size());
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  for (std::size_t i = 0; i < times.size(); ++i)
    ASSERT_LT((track.at(times[i]).tip - joined.tips[i]).norm(), 0.1) << i; // the lead away is 2 mm long
}

TEST(Playback, AProgramIsPlayedLineByLineAndLeavesTheStockOfTheJudge)
{
  ProgramPlanner planner;
  planner.setInputPlan(spiral().getPlan());
  planner.setMachine(xyzacTrunnion());
  MachineProgram program;
  planner.compute(program);
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  const ScratchFolder folder;
  const std::string file = folder.path("part.ngc");
  writeProgram(file, program, Dialect::LinuxCNC, ProgramHeader());
  GivenPath given;
  given.program = readProgram(file, xyzacTrunnion());
  Judged judged;
  judge(given, judged);
  PlaybackInput input = inputOf(judged);
  input.program = given.program;
  input.lines = judged.path.verification.program->lines;
  PlaybackTime time;
  const Status status = playbackTime(input, time);
  ASSERT_TRUE(status.ok()) << status.message();
  expectOnThePath(input, time, 0.004);
  EXPECT_NEAR(time.track.seconds(), motionTime(given.program->program, input.control)->seconds, 1e-9);
  for (std::size_t i = 0; i < input.path->size(); i += 50)
    EXPECT_EQ(time.lines[time.track.at(time.reached[i] - 1e-7).block], input.lines[i]);
  const ReferenceSurface& reference = *judged.judge.parts().front().reference;
  const StockMesh mesh = stockMesh(reference, judged.path.heights.stock);
  StockFalls falls;
  ASSERT_TRUE(playbackStock(input, mesh, judged.path.verification.removal, falls).ok());
  const std::size_t all = movesAfter(time, time.track.seconds());
  EXPECT_EQ(all + 1, input.path->size());
  for (std::size_t place = 0; place < falls.places(); ++place) {
    ASSERT_NEAR(falls.heightAfter(place, all), mesh.stock[place], 1e-3) << place;
    ASSERT_EQ(falls.heightAfter(place, 0), falls.reach);
  }
}

} // namespace playback_test
