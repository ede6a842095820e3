// SPDX-License-Identifier: BSD-3-Clause
// Speed of a beam over a ridge: programs of rows, read back, and the path of the contact in the time of every block.
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/ridge/ridge_toolpath.h>

#include "support/beam_way.h"
#include "support/ridges.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ridge_feed_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double feed = 600.0, stand_off = 10.0;

/** An arch that reaches 36 mm inward from a ring of radius 50; its chord rises by \p theta degrees. */
ExactRidge
archedRing(double theta)
{
  return ringRidge(
      50.0, [](double w) { return Vector3d(0.0, 36.0 * w, 15.0 * w * (1.0 - w)); }, theta * M_PI / 180.0);
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
cloudOf(const std::vector<Vector3d>& points)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Vector3d& p : points)
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  return cloud;
}

DrivePasses
ringRows(const ExactRidge& ring, RidgeDirection direction, RidgeSteps steps)
{
  std::vector<Vector3d> rail = ring.railPoints(315);
  rail.pop_back();
  RidgeToolpath<pcl::PointXYZ> ridge;
  ridge.setInputCloud(cloudOf(rail));
  ridge.setInputGenerator(cloudOf(ring.generatorPoints(0.2, 80)));
  ridge.setStepOver(direction == RidgeDirection::AlongRail ? 6.0 : 40.0);
  ridge.setStandOff(stand_off);
  ridge.setDirection(direction);
  ridge.setSteps(steps);
  DrivePasses rows;
  ridge.compute(rows);
  EXPECT_TRUE(ridge.getStatus().ok()) << ridge.getStatus().message();
  return rows;
}

/** Poses of a beam; rings come back to their first place. */
std::vector<ToolPoses>
beamPoses(const DrivePasses& rows)
{
  std::vector<ToolPoses> passes;
  for (const DrivePass& row : rows) {
    passes.emplace_back();
    for (const DrivePoint& p : row.points)
      passes.back().push_back({p.position, p.axis.normalized(), p.position - stand_off * p.normal, p.normal});
    if (row.closed)
      passes.back().push_back(ToolPose(passes.back().front()));
  }
  return passes;
}

/** A machine whose axes slow no block. */
Machine
fastMachine(bool rtcp)
{
  Machine machine = testMachines()[0];
  for (RotaryAxis& axis : machine.rotary)
    axis.range.largest_rate = 1e9;
  machine.rtcp = rtcp;
  return machine;
}

MachineProgram
programFor(const Machine& machine, const std::vector<ToolPoses>& passes)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPasses(passes);
  ProgramSettings settings;
  settings.feed = feed;
  generator.setSettings(settings);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

/** The program as LinuxCNC reads it from its text. */
ParsedProgram
readBack(const MachineProgram& program)
{
  const ScratchFolder folder;
  ProgramHeader header;
  header.pass_begin = on_code;
  header.pass_end = off_code;
  writeLinuxCNC(folder.path("rings.ngc"), program, header);
  return parseFanuc(folder.path("rings.ngc"));
}

/** Place where the beam meets the surface, at share \p t of the way from \p a to \p b: the axes move linearly. */
Vector3d
spotAt(const Machine& machine, const ParsedMove& a, const ParsedMove& b, double t)
{
  ParsedMove at;
  at.xyz = a.xyz + t * (b.xyz - a.xyz);
  for (const auto& [letter, degrees] : a.degrees)
    at.degrees[letter] = degrees + t * (b.degrees.at(letter) - degrees);
  const TipAndAxis tool = where(machine, at);
  return tool.tip - stand_off * tool.axis;
}

struct Speeds {
  double slowest = 1e9, fastest = 0.0;         ///< of the spot, mm/min
  double slowest_tip = 1e9, fastest_tip = 0.0; ///< of the tip
  std::size_t blocks = 0;
  double length = 0.0; ///< of the path of the spot
};

/** Over all moves with the beam on. */
Speeds
speedsOf(const Machine& machine, const ParsedProgram& program)
{
  Speeds speeds;
  for (const Beam& beam : beamsOf(program))
    for (std::size_t i = beam.on; i < beam.off; ++i) {
      const ParsedMove &a = program.moves[i - 1], &b = program.moves[i];
      constexpr int parts = 4;
      double way = 0.0;
      for (int j = 0; j < parts; ++j)
        way += (spotAt(machine, a, b, (j + 1.0) / parts) - spotAt(machine, a, b, static_cast<double>(j) / parts)).norm();
      const double tip = (where(machine, b).tip - where(machine, a).tip).norm() / b.minutes;
      speeds.slowest = std::min(speeds.slowest, way / b.minutes);
      speeds.fastest = std::max(speeds.fastest, way / b.minutes);
      speeds.slowest_tip = std::min(speeds.slowest_tip, tip);
      speeds.fastest_tip = std::max(speeds.fastest_tip, tip);
      speeds.length += way;
      ++speeds.blocks;
    }
  return speeds;
}

} // namespace

TEST(RidgeFeed, TipsStandOffTheExactSurface)
{
  const ExactRidge ring = archedRing(0.0);
  const DrivePasses rows = ringRows(ring, RidgeDirection::AlongRail, RidgeSteps::EqualOnRow);
  ASSERT_GE(rows.size(), 6U);
  double shortest = 1e9, longest = 0.0;
  for (const DrivePass& row : rows) {
    ASSERT_TRUE(row.closed);
    const double round = 2.0 * M_PI * row.points[0].position.head<2>().norm();
    shortest = std::min(shortest, round);
    longest = std::max(longest, round);
    for (std::size_t i = 0; i < row.points.size(); i += 7) {
      const DrivePoint& p = row.points[i];
      EXPECT_LT(ring.distance(p.position - stand_off * p.normal), 2e-3);
      EXPECT_NEAR(ring.distance(p.position), stand_off, 2e-3);
      EXPECT_LT((p.axis - p.normal).norm(), 1e-9);
    }
  }
  EXPECT_GT(longest / shortest, 2.5) << "rings of unequal length";
}

namespace {

/** Over all rows, by the program's text, the spot moves at the feed asked for; the tip does not. */
void
expectFeed(const ExactRidge& ring, RidgeDirection direction, RidgeSteps steps, bool rtcp)
{
  const Machine machine = fastMachine(rtcp);
  const std::vector<ToolPoses> passes = beamPoses(ringRows(ring, direction, steps));
  const ParsedProgram read = readBack(programFor(machine, passes));
  ASSERT_EQ(beamsOf(read).size(), passes.size());
  const Speeds speeds = speedsOf(machine, read);
  EXPECT_GT(speeds.slowest, 0.99 * feed);
  EXPECT_LT(speeds.fastest, 1.01 * feed);
  double length = 0.0;
  for (const ToolPoses& pass : passes)
    for (std::size_t i = 1; i < pass.size(); ++i)
      length += (pass[i].contact - pass[i - 1].contact).norm();
  EXPECT_NEAR(speeds.length / length, 1.0, 1e-3) << "all rows are on the way of a beam";
  EXPECT_TRUE(speeds.slowest_tip < 0.9 * feed || speeds.fastest_tip > 1.1 * feed) << "the feed is not the tip's";
  std::printf("%zu rows, %zu blocks: spot %.2f to %.2f, tip %.1f to %.1f mm/min\n", passes.size(), speeds.blocks, speeds.slowest,
              speeds.fastest, speeds.slowest_tip, speeds.fastest_tip);
}

} // namespace

TEST(RidgeFeed, TheSpotKeepsTheFeedOnRingsOfUnequalLength)
{
  for (const double theta : {0.0, 40.0})
    for (const RidgeSteps steps : {RidgeSteps::EqualOnRow, RidgeSteps::Stations})
      for (const bool rtcp : {true, false})
        expectFeed(archedRing(theta), RidgeDirection::AlongRail, steps, rtcp);
}

/** With a rise of 40 degrees the arch is nowhere level: at a level place C would turn round, and the block would last as long. */
TEST(RidgeFeed, TheSpotKeepsTheFeedAcrossTheRail)
{
  for (const RidgeSteps steps : {RidgeSteps::EqualOnRow, RidgeSteps::Stations})
    for (const bool rtcp : {true, false})
      expectFeed(archedRing(40.0), RidgeDirection::AcrossRail, steps, rtcp);
}

} // namespace ridge_feed_test
