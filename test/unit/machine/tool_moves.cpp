// SPDX-License-Identifier: BSD-3-Clause
// Leads without a machine: by hand, against those of machine programs, under a part, and looked at by LeadCheck.
#include <pcl_spiral/machine/impl/tool_pose.h>
#include <pcl_spiral/machine/tool_moves.h>
#include <pcl_spiral/verify/lead_check.h>

#include "core/angle_between.h"
#include "support/dome_spiral.h"
#include "support/random_vectors.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

namespace tool_moves_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double cutter_radius = 6.0;

/** Three stretches of a spiral over a dome, each a pass. */
std::vector<ToolPoses>
threePasses()
{
  const ToolPoses all = domeSpiral(200.0, 2.0, 12, 60, cutter_radius, 13.0);
  const auto part = [&all](std::ptrdiff_t begin, std::ptrdiff_t end) { return ToolPoses(all.begin() + begin, all.begin() + end); };
  return {part(300, 330), part(400, 480), part(600, 690)};
}

/** The same passes turned and shifted. */
std::vector<ToolPoses>
moved(std::vector<ToolPoses> passes, const Eigen::Quaterniond& turn, const Eigen::Vector3d& shift)
{
  for (ToolPoses& pass : passes)
    for (ToolPose& pose : pass)
      pose = {turn * pose.tip + shift, turn * pose.axis, turn * pose.contact + shift, turn * pose.normal};
  return passes;
}

std::vector<const ToolMove*>
offThePath(const std::vector<ToolMoves>& passes)
{
  std::vector<const ToolMove*> found;
  for (const ToolMoves& pass : passes)
    for (const ToolMove& move : pass)
      if (move.section != BlockSection::Cut)
        found.push_back(&move);
  return found;
}

} // namespace

TEST(ToolMoves, LeadsAreWhereTheSettingsPutThem)
{
  ProgramSettings settings;
  settings.feed = 600.0;
  settings.lead_length = 3.0;
  settings.clearance = 7.0;
  settings.rapid_height = 40.0;
  settings.clear_box = Eigen::AlignedBox3d(Eigen::Vector3d(0.0, 0.0, -9.0), Eigen::Vector3d(1.0, 2.0, 60.0));
  const std::vector<ToolPoses> passes = threePasses();
  const std::vector<ToolMoves> led = ledPasses({passes[0], {}, passes[1], passes[2]}, settings);
  ASSERT_EQ(led.size(), 3U); // the empty one is left out
  for (std::size_t k = 0; k < led.size(); ++k) {
    const ToolMoves& moves = led[k];
    const ToolPose &first = passes[k].front(), &last = passes[k].back();
    ASSERT_EQ(moves.size(), passes[k].size() + 8);
    const auto tip = [&moves](std::size_t i) { return moves[i].pose.tip; };
    EXPECT_EQ(moves[0].section, BlockSection::Position);
    EXPECT_NEAR(tip(0).z(), 100.0, 1e-9);
    EXPECT_LT((tip(0).head<2>() - tip(1).head<2>()).norm(), 1e-9);
    EXPECT_LT((tip(1) - (first.tip + 3.0 * first.normal + 47.0 * first.axis)).norm(), 1e-9);
    EXPECT_LT((tip(2) - (first.tip + 3.0 * first.normal + 7.0 * first.axis)).norm(), 1e-9);
    EXPECT_LT((tip(3) - (first.tip + 3.0 * first.normal)).norm(), 1e-9);
    EXPECT_LT((tip(4) - first.tip).norm(), 1e-12);
    EXPECT_EQ(moves[4].section, BlockSection::LeadIn);
    EXPECT_LT((moves[1].pose.contact - moves[1].pose.tip - (first.contact - first.tip)).norm(), 1e-9);
    for (std::size_t i = 1; i < passes[k].size(); ++i) {
      const ToolMove& move = moves[4 + i];
      EXPECT_EQ(move.section, BlockSection::Cut);
      EXPECT_EQ(move.pose.tip, passes[k][i].tip);
      EXPECT_NEAR(move.minutes, (passes[k][i].contact - passes[k][i - 1].contact).norm() / 600.0, 1e-12);
    }
    const std::size_t end = moves.size() - 1;
    EXPECT_LT((tip(end - 3) - (last.tip + 3.0 * last.normal)).norm(), 1e-9);
    EXPECT_LT((tip(end - 2) - (last.tip + 3.0 * last.normal + 7.0 * last.axis)).norm(), 1e-9);
    EXPECT_NEAR(tip(end).z(), 100.0, 1e-9);
    for (std::size_t i : {0UL, 1UL, 2UL, end - 1, end})
      EXPECT_TRUE(moves[i].rapid);
    for (std::size_t i : {3UL, 4UL, end - 3, end - 2})
      EXPECT_FALSE(moves[i].rapid);
  }
}

TEST(ToolMoves, TheyAreTheLeadsOfAMachineProgram)
{
  for (const LeadKind lead : {LeadKind::Normal, LeadKind::Arc})
    for (const Machine& machine : testMachines()) {
      ProgramSettings settings;
      settings.lead = lead;
      MachineProgramGenerator generator;
      generator.setMachine(machine);
      generator.setInputPasses(threePasses());
      generator.setSettings(settings);
      MachineProgram program;
      generator.compute(program);
      ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
      const std::vector<ToolMoves> of_program{movesOf(program)}, led = ledPasses(threePasses(), settings);
      const auto a = offThePath(of_program), b = offThePath(led);
      ASSERT_EQ(a.size(), b.size()) << machine.name;
      for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i]->section, b[i]->section);
        ASSERT_EQ(a[i]->rapid, b[i]->rapid);
        ASSERT_LT((a[i]->pose.tip - b[i]->pose.tip).norm(), 1e-7) << machine.name << " " << i;
        ASSERT_LT(angleBetween(a[i]->pose.axis, b[i]->pose.axis), 1e-9);
        ASSERT_NEAR(a[i]->minutes, b[i]->minutes, 1e-9);
      }
    }
}

TEST(ToolMoves, AFiniteFirstAxisTurnsBackWithoutMovesOfTheTool)
{
  Machine machine = xyzacTrunnion();
  machine.rotary[0].range.lower = -4.0;
  machine.rotary[0].range.upper = 4.0;
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPoses(domeSpiral(200.0, 2.0, 12, 60, cutter_radius, 13.0));
  MachineProgram program;
  generator.compute(program);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  ASSERT_FALSE(program.report.unwound_at.empty());
  const auto turns = std::count_if(program.blocks.begin(), program.blocks.end(),
                                   [](const ProgramBlock& block) { return block.section == BlockSection::Unwind; });
  ASSERT_GT(turns, 0);
  EXPECT_EQ(movesOf(program).size() + static_cast<std::size_t>(turns), program.blocks.size());
}

TEST(ToolMoves, WhereverThePartPointsTheToolLeavesOnItsOwnSide)
{
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), randomUnit(random));
    const std::vector<ToolPoses> passes = moved(threePasses(), turn, randomVector(random, 100.0));
    // The dome is below its pole, along its axis of revolution.
    const Eigen::Vector3d out = turn * Eigen::Vector3d::UnitZ();
    double highest = -1e9;
    for (const ToolPoses& pass : passes)
      for (const ToolPose& pose : pass)
        highest = std::max(highest, pose.contact.dot(out));
    for (const ToolMoves& moves : ledPasses(passes, {}))
      for (std::size_t i = 1; i < moves.size(); ++i)
        if (moves[i].section == BlockSection::Approach || moves[i].section == BlockSection::Retract) {
          const Eigen::Vector3d way = moves[i].pose.tip - moves[i - 1].pose.tip;
          const double away = moves[i].section == BlockSection::Retract ? 1.0 : -1.0;
          ASSERT_GT(away * way.normalized().dot(moves[i].pose.axis), -0.01) << trial << ": into the part";
        }
    if (out.z() < -0.3) // hangs: the way from pass to pass is below all of it, which is along its own axis
      for (const ToolMoves& moves : ledPasses(passes, {}))
        ASSERT_GT(moves.front().pose.tip.dot(out), highest + 40.0) << trial;
  }
}

TEST(ToolMoves, LeadCheckFindsAPostInTheirWay)
{
  const std::vector<ToolPoses> passes = threePasses();
  const std::vector<ToolMoves> led = ledPasses(passes, {});
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const ToolPoses& pass : passes)
    for (const ToolPose& pose : pass)
      cloud->push_back({static_cast<float>(pose.contact.x()), static_cast<float>(pose.contact.y()), static_cast<float>(pose.contact.z())});
  const auto collisions = [&cloud, &led] {
    LeadCheck<pcl::PointXYZ> check;
    check.setInputCloud(cloud);
    check.setCutter(CutterShape::ball(cutter_radius));
    check.compute(programOf(led));
    EXPECT_TRUE(check.getStatus().ok()) << check.getStatus().message();
    return check.getReport();
  };
  EXPECT_EQ(collisions().collided, 0U);
  const ToolPose& end = passes[1].back(); // 4 mm beside the axis, 20 mm above the tip: in the shank
  const Eigen::Vector3d post = end.tip + 22.0 * end.axis + 4.0 * end.axis.unitOrthogonal();
  cloud->push_back({static_cast<float>(post.x()), static_cast<float>(post.y()), static_cast<float>(post.z())});
  const LeadReport found = collisions();
  EXPECT_GT(found.collided, 0U);
  EXPECT_LT((found.deepest.place - post).norm(), 1e-4);
  EXPECT_NEAR(found.deepest.depth, cutter_radius - 4.0, 0.01);
}

} // namespace tool_moves_test
