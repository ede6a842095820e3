// SPDX-License-Identifier: BSD-3-Clause
// Links between rows over a sphere: where they run by the oracle's kinematics, and which are blocked by brute force.
#include "verify/blocked_links.h"
#include <pcl_spiral/machine/impl/tool_pose.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include "support/machine_way.h"
#include "support/random_vectors.h"
#include "support/test_machines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace stay_down_links_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double sphere = 80.0, cutter = 4.0, lead = 2.0, row_distance = 1.5;
constexpr std::size_t row_count = 12;

/** The contact above (x, y) on the sphere about (0, 0, -sphere). */
Eigen::Vector3d
onSphere(double x, double y)
{
  return {x, y, std::sqrt(sphere * sphere - x * x - y * y) - sphere};
}

/** Rows to and fro beside the pole of the sphere, of a ball whose axis leans by 20 degrees about x. */
std::vector<ToolPoses>
rows()
{
  const Eigen::Vector3d centre(0.0, 0.0, -sphere);
  std::vector<ToolPoses> passes(row_count);
  for (std::size_t k = 0; k < row_count; ++k)
    for (int i = 0; i <= 20; ++i) {
      const double y = (k % 2 == 0 ? 1.0 : -1.0) * (i - 10.0);
      ToolPose pose;
      pose.contact = onSphere(12.0 + row_distance * static_cast<double>(k), y);
      pose.normal = (pose.contact - centre).normalized();
      pose.axis = Eigen::AngleAxisd(20.0 * M_PI / 180.0, Eigen::Vector3d::UnitX()) * pose.normal;
      pose.tip = pose.contact + cutter * (pose.normal - pose.axis);
      passes[k].push_back(pose);
    }
  return passes;
}

MachineProgram
made(const Machine& machine, double stay_down, const std::vector<std::size_t>& retracted = {})
{
  MachineProgramGenerator generator;
  generator.setMachine(machine);
  generator.setInputPasses(rows());
  ProgramSettings settings;
  settings.lead_length = lead;
  settings.stay_down = stay_down;
  settings.ball_radius = cutter;
  generator.setSettings(settings);
  generator.setRetractedPasses(retracted);
  MachineProgram program;
  generator.compute(program);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return program;
}

/** Every machine, with tips and with its own axes. */
std::vector<Machine>
machines()
{
  std::vector<Machine> all = testMachines();
  for (Machine machine : testMachines()) {
    machine.rtcp = false;
    all.push_back(machine);
  }
  return all;
}

double
wayOfTip(const MachineProgram& program)
{
  double way = 0.0;
  for (std::size_t i = 1; i < program.blocks.size(); ++i)
    way += (program.blocks[i].tip - program.blocks[i - 1].tip).norm();
  return way;
}

/** Passes to which a link leads. */
std::set<std::size_t>
linkedPasses(const MachineProgram& program)
{
  std::set<std::size_t> passes;
  for (const ProgramBlock& block : program.blocks)
    if (block.section == BlockSection::Link)
      passes.insert(block.pass);
  return passes;
}

/** Distance of \p p from a ball cutter with an endless shank; negative inside. */
double
distanceTo(const Eigen::Vector3d& p, const TipAndAxis& tool)
{
  const Eigen::Vector3d from = p - (tool.tip + cutter * tool.axis);
  const double along = from.dot(tool.axis);
  return (along < 0.0 ? from.norm() : (from - along * tool.axis).norm()) - cutter;
}

/** The least distance of a point of the cloud from the tool on the link to each pass. */
std::vector<double>
leastDistances(const Cloud& cloud, const MachineProgram& program)
{
  std::vector<double> least(row_count, INFINITY);
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    const ProgramBlock& block = program.blocks[i];
    if (block.section != BlockSection::Link)
      continue;
    for (int s = 0; s <= 40; ++s) {
      const TipAndAxis tool = onTheWay(program.machine, program.blocks[i - 1], block, s / 40.0);
      for (const pcl::PointXYZ& p : cloud)
        least[block.pass] = std::min(least[block.pass], distanceTo(p.getVector3fMap().cast<double>(), tool));
    }
  }
  return least;
}

Cloud::Ptr
sphereCloud()
{
  const auto cloud = pcl::make_shared<Cloud>();
  for (double x = 0.0; x <= 40.0; x += 0.8)
    for (double y = -18.0; y <= 18.0; y += 0.8) {
      const Eigen::Vector3f p = onSphere(x, y).cast<float>();
      cloud->push_back({p.x(), p.y(), p.z()});
    }
  return cloud;
}

std::vector<std::size_t>
blockedPasses(const Cloud::ConstPtr& cloud, const MachineProgram& program, double room)
{
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(cloud);
  check.setCutter(CutterShape::ball(cutter));
  check.setTolerance(0.02);
  check.setNumberOfThreads(1); // there are few moves
  std::vector<std::size_t> passes;
  const Status status = findBlockedLinks(check, program, room, passes);
  EXPECT_TRUE(status.ok()) << status.message();
  return passes;
}

} // namespace

TEST(StayDownLinks, StayAtTheHeightOfTheLeadsAndNeverInTheSurface)
{
  const Eigen::Vector3d centre(0.0, 0.0, -sphere);
  for (const Machine& machine : machines()) {
    const MachineProgram program = made(machine, 10.0), retracts = made(machine, 0.0);
    EXPECT_EQ(program.report.links, row_count - 1) << machine.name;
    EXPECT_EQ(linkedPasses(program).size(), row_count - 1);
    for (std::size_t i = 1; i < program.blocks.size(); ++i) {
      const ProgramBlock &before = program.blocks[i - 1], &block = program.blocks[i];
      if (block.section != BlockSection::Link) {
        ASSERT_TRUE(before.section != BlockSection::Link || block.section == BlockSection::LeadIn);
        continue;
      }
      ASSERT_TRUE(before.section == BlockSection::LeadOut || before.section == BlockSection::Link);
      ASSERT_FALSE(block.rapid);
      ASSERT_GT(block.minutes, 0.0);
      for (int s = 0; s <= 20; ++s) { // the ball's centre, from the surface: its radius and the height of the lead
        const TipAndAxis tool = onTheWay(machine, before, block, s / 20.0);
        const double height = (tool.tip + cutter * tool.axis - centre).norm() - sphere - cutter;
        ASSERT_GT(height, 0.97 * lead) << machine.name << " block " << i;
        ASSERT_LT(height, 1.03 * lead);
      }
    }
    // What retracts and what links have in common is the same.
    EXPECT_NEAR(wayOfTip(retracts) - wayOfTip(program), program.report.saved_way, 1e-6) << machine.name;
    EXPECT_GT(program.report.saved_way, 100.0 * (row_count - 1));
    const auto cuts = [](const MachineProgram& some) {
      std::vector<Eigen::Vector3d> tips;
      for (const ProgramBlock& block : some.blocks)
        if (block.section == BlockSection::Cut || block.section == BlockSection::LeadIn || block.section == BlockSection::LeadOut)
          tips.push_back(block.tip);
      return tips;
    };
    EXPECT_EQ(cuts(program), cuts(retracts));
  }
}

TEST(StayDownLinks, LongerWaysAndPassesThatAreNamedRetract)
{
  for (const Machine& machine : testMachines()) {
    const MachineProgram retracts = made(machine, 0.0), none = made(machine, 0.9 * row_distance);
    ASSERT_EQ(none.blocks.size(), retracts.blocks.size()); // a lead ends farther away than the next row
    EXPECT_EQ(none.report.links, 0U);
    const MachineProgram some = made(machine, 10.0, {3, 4, 11});
    EXPECT_EQ(linkedPasses(some), (std::set<std::size_t>{1, 2, 5, 6, 7, 8, 9, 10}));
    EXPECT_EQ(some.report.links, 8U);
    EXPECT_EQ(some.report.blocked_links, 3U);
    std::set<std::size_t> from_above;
    for (const ProgramBlock& block : some.blocks)
      if (block.section == BlockSection::Position)
        from_above.insert(block.pass);
    EXPECT_EQ(from_above, (std::set<std::size_t>{0, 3, 4, 11}));
  }
}

TEST(StayDownLinks, AFirstAxisThatMustTurnBackRetracts)
{
  std::vector<ToolPoses> passes(2); // on a plane, C at 170 and at 190 degrees
  for (std::size_t k = 0; k < 2; ++k)
    for (int i = 0; i <= 5; ++i) {
      const double c = (k == 0 ? 170.0 : 190.0) * M_PI / 180.0, a = 30.0 * M_PI / 180.0;
      ToolPose pose;
      pose.contact = {static_cast<double>(k), k == 0 ? i : 5.0 - i, 0.0};
      pose.axis = {std::sin(c) * std::sin(a), std::cos(c) * std::sin(a), std::cos(a)};
      pose.tip = pose.contact + cutter * (pose.normal - pose.axis);
      passes[k].push_back(pose);
    }
  Machine machine = testMachines()[0];
  for (const bool limited : {false, true}) {
    if (limited) {
      machine.rotary[0].range.lower = -M_PI;
      machine.rotary[0].range.upper = M_PI;
    }
    MachineProgramGenerator generator;
    generator.setMachine(machine);
    generator.setInputPasses(passes);
    ProgramSettings settings;
    settings.stay_down = 10.0;
    generator.setSettings(settings);
    MachineProgram program;
    generator.compute(program);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    EXPECT_EQ(program.report.links, limited ? 0U : 1U);
    const bool turns = std::any_of(program.blocks.begin(), program.blocks.end(),
                                   [](const ProgramBlock& block) { return block.section == BlockSection::Unwind; });
    EXPECT_EQ(turns, limited);
  }
}

TEST(StayDownLinks, WhatIsBlockedIsWhatBruteForceFinds)
{
  constexpr double room = 0.5 * lead, unsure = 0.06; // mm: what LeadCheck may miss between two looks, and its tolerance
  Random random(11);
  std::size_t blocked = 0, open = 0;
  for (const Machine& machine : machines()) {
    const MachineProgram program = made(machine, 10.0);
    EXPECT_TRUE(blockedPasses(sphereCloud(), program, room).empty()) << machine.name;
    for (int trial = 0; trial < 4; ++trial) {
      const auto cloud = sphereCloud();
      for (int post = 0; post < 6; ++post) { // the tops of posts near the ends of rows
        const double x = 12.0 + random.uniform(0.0, row_distance * (row_count - 1)), y = random.below(2) == 0 ? 10.0 : -10.0;
        const Eigen::Vector3f top =
            (onSphere(x, y + random.uniform(-3.0, 3.0)) + Eigen::Vector3d(0, 0, random.uniform(0.0, 4.0))).cast<float>();
        cloud->push_back({top.x(), top.y(), top.z()});
      }
      const std::vector<std::size_t> found = blockedPasses(cloud, program, room);
      const std::vector<double> least = leastDistances(*cloud, program);
      for (std::size_t pass = 1; pass < row_count; ++pass) {
        const bool is = std::find(found.begin(), found.end(), pass) != found.end();
        if (least[pass] < room - unsure)
          EXPECT_TRUE(is) << machine.name << ": a point " << least[pass] << " mm from the link to pass " << pass;
        if (least[pass] > room + unsure)
          EXPECT_FALSE(is) << machine.name << ": nothing nearer than " << least[pass] << " mm to the link to pass " << pass;
        (is ? blocked : open) += 1;
      }
    }
  }
  EXPECT_GT(blocked, 50U);
  EXPECT_GT(open, 50U);
}

TEST(StayDownLinks, APostBetweenTwoRowsSendsTheToolUpThereAndOnlyThere)
{
  const Machine machine = testMachines()[0];
  const MachineProgram program = made(machine, 10.0);
  const auto cloud = sphereCloud();
  const auto link = std::find_if(program.blocks.begin(), program.blocks.end(),
                                 [](const ProgramBlock& block) { return block.section == BlockSection::Link && block.pass == 7; });
  const Eigen::Vector3f post = (0.5 * ((link - 1)->tip + link->tip) + 0.1 * link->axis).cast<float>();
  cloud->push_back({post.x(), post.y(), post.z()});
  const std::vector<double> least = leastDistances(*cloud, program);
  std::vector<std::size_t> expected;
  for (std::size_t pass = 1; pass < row_count; ++pass)
    if (least[pass] < 0.5 * lead)
      expected.push_back(pass);
  EXPECT_NE(std::find(expected.begin(), expected.end(), 7U), expected.end());
  EXPECT_LE(expected.size(), 5U);
  const std::vector<std::size_t> blocked = blockedPasses(cloud, program, 0.5 * lead);
  EXPECT_EQ(blocked, expected);
  const MachineProgram safe = made(machine, 10.0, blocked);
  EXPECT_TRUE(blockedPasses(cloud, safe, 0.5 * lead).empty());
  EXPECT_EQ(safe.report.links, row_count - 1 - blocked.size());
}

} // namespace stay_down_links_test
