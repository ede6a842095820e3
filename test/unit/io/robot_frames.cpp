// SPDX-License-Identifier: BSD-3-Clause
// Robot frames read back by yaml-cpp in the way of noether: nested sequences of maps, each key by its name.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>

#include "core/angle_between.h"
#include "support/dome_spiral.h"
#include "support/random_vectors.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

namespace robot_frames_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Segment = std::vector<Eigen::Isometry3d>;
using Fragments = std::vector<std::vector<std::vector<Segment>>>; // of paths of segments of waypoints

/** What noether's reader takes of a waypoint: the seven values that it asks for, metres. */
Eigen::Isometry3d
waypointOf(const YAML::Node& node)
{
  const auto member = [&node](const char* key) {
    if (!node[key])
      throw std::runtime_error(std::string("no ") + key);
    return node[key].as<double>();
  };
  const Eigen::Quaterniond turn(member("qw"), member("qx"), member("qy"), member("qz"));
  return Eigen::Translation3d(member("x"), member("y"), member("z")) * turn;
}

template <typename Item, typename Read>
std::vector<Item>
listOf(const YAML::Node& node, const Read& read)
{
  EXPECT_TRUE(node.IsSequence());
  std::vector<Item> items;
  for (const YAML::Node& item : node)
    items.push_back(read(item));
  return items;
}

Fragments
readFragments(const std::string& file)
{
  const auto segment = [](const YAML::Node& node) { return listOf<Eigen::Isometry3d>(node, waypointOf); };
  const auto path = [&](const YAML::Node& node) { return listOf<Segment>(node, segment); };
  const auto fragment = [&](const YAML::Node& node) { return listOf<std::vector<Segment>>(node, path); };
  return listOf<std::vector<std::vector<Segment>>>(YAML::LoadFile(file), fragment);
}

/** Passes of a tapered bull-nose: the tip is neither at the contact nor on a line with it and the axis. */
std::vector<ToolPoses>
testPasses(const Eigen::Isometry3d& motion)
{
  std::vector<ToolPoses> passes(3);
  const ToolPoses all = domeSpiral(80.0, 1.5, 9, 70, 4.0, 25.0);
  for (std::size_t i = 0; i < 300; ++i) {
    ToolPose pose = all[i + 70];
    pose.tip += 1.3 * pose.axis.cross(pose.normal);
    pose = {motion * pose.tip, motion.linear() * pose.axis, motion * pose.contact, motion.linear() * pose.normal};
    passes[i < 40 ? 0 : i < 41 ? 1 : 2].push_back(pose);
  }
  return passes;
}

/** Heights, a tenth of a millimetre apart, with valleys, steps of up to 3 mm and edges. */
std::vector<double>
brokenProfile(Random& random)
{
  std::vector<double> heights;
  double z = 0.0;
  while (heights.size() < 600) {
    const double slope = random.uniform(-1.5, 1.5);
    z += random.uniform(0.0, 1.0) < 0.3 ? random.uniform(-3.0, 3.0) : 0.0;
    for (int i = static_cast<int>(random.uniform(20.0, 80.0)); i-- > 0; z += 0.1 * slope)
      heights.push_back(z);
  }
  return heights;
}

/** A ball of 4 mm rolled over \p heights along x, upright; the way bends a little to the side. */
ToolPoses
rolledPass(const std::vector<double>& heights)
{
  constexpr double radius = 4.0, step = 0.1;
  constexpr int reach = 40;
  ToolPoses pass;
  for (int i = reach; i + reach < static_cast<int>(heights.size()); ++i) {
    double top = -1e9;
    int touched = i;
    for (int k = -reach; k <= reach; ++k)
      if (const double centre = heights[i + k] + std::sqrt(std::max(0.0, radius * radius - step * step * k * k)); centre > top) {
        top = centre;
        touched = i + k;
      }
    const double side = 3.0 * std::sin(0.002 * i);
    const Eigen::Vector3d centre(step * i, side, top), contact(step * touched, side, heights[touched]);
    pass.push_back({centre - radius * Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), contact, (centre - contact) / radius});
  }
  return pass;
}

Eigen::Isometry3d
randomMotion(Random& random)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(random.uniform(-3.0, 3.0), randomUnit(random)).toRotationMatrix();
  motion.translation() = randomVector(random, 500.0);
  return motion;
}

} // namespace

TEST(RobotFrames, AreReadBackAsNoetherReadsThem)
{
  const ScratchFolder folder;
  const std::string file = folder.path("a.yaml");
  Random random(3);
  for (int trial = 0; trial < 8; ++trial)
    for (const RobotZ kind : {RobotZ::Axis, RobotZ::Normal}) {
      const std::vector<ToolPoses> passes = testPasses(randomMotion(random));
      const std::vector<ToolMoves> moves = ledPasses(passes, {});
      writeRobotFrames(file, moves, kind);
      const Fragments fragments = readFragments(file);
      ASSERT_EQ(fragments.size(), 1U);
      ASSERT_EQ(fragments[0].size(), 1U);
      ASSERT_EQ(fragments[0][0].size(), passes.size());
      for (std::size_t k = 0; k < passes.size(); ++k) {
        const Segment& segment = fragments[0][0][k];
        ASSERT_EQ(segment.size(), moves[k].size());
        const auto first = static_cast<std::size_t>(
            std::find_if(moves[k].begin(), moves[k].end(),
                         [&](const ToolMove& move) { return (move.pose.tip - passes[k].front().tip).norm() < 1e-12; }) -
            moves[k].begin());
        for (std::size_t i = 0; i < segment.size(); ++i) {
          const Eigen::Matrix3d frame = segment[i].linear();
          ASSERT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-8);
          ASSERT_NEAR(frame.determinant(), 1.0, 1e-8);
          const std::size_t at = std::min(i < first ? 0 : i - first, passes[k].size() - 1); // on leads the end of the path
          const ToolPose& pose = passes[k][at];
          const Eigen::Vector3d z = kind == RobotZ::Axis ? pose.axis : pose.normal;
          ASSERT_LT((frame.col(2) - z).norm(), 1e-6);
          const bool on_path = i >= first && i < first + passes[k].size();
          if (on_path) // to a nanometre
            ASSERT_LT((1e3 * segment[i].translation() - (kind == RobotZ::Axis ? pose.tip : pose.contact)).cwiseAbs().maxCoeff(), 1e-6);
          else // the tool is moved, not turned
            ASSERT_LT((1e3 * (segment[i].translation() - segment[i < first ? first : first + passes[k].size() - 1].translation()) -
                       (moves[k][i].pose.tip - pose.tip))
                          .norm(),
                      5e-6);
          if (passes[k].size() < 2)
            continue;
          const std::size_t from = std::min(at, passes[k].size() - 2);
          Eigen::Vector3d travel = passes[k][from + 1].tip - passes[k][from].tip;
          travel -= travel.dot(z) * z;
          ASSERT_LT((frame.col(0) - travel.normalized()).norm(), 1e-6) << k << " " << i;
        }
      }
    }
}

TEST(RobotFrames, DoNotFlipInValleysAtStepsAndAtEdges)
{
  Random random(11);
  for (int trial = 0; trial < 40; ++trial) {
    ToolPoses pass = rolledPass(brokenProfile(random));
    for (std::size_t i = 0; i < pass.size(); i += 7) // as between the walls of a valley that the way meets at an angle
      pass[i].contact -= Eigen::Vector3d(3.0, random.uniform(-1.0, 1.0), 0.0);
    const std::vector<ToolMoves> moves = ledPasses({pass}, {});
    double travel_turns = 0.0;
    const auto wayTo = [&](std::size_t i) -> Eigen::Vector3d { return (pass[i].tip - pass[i - 1].tip).normalized(); };
    for (std::size_t i = 2; i < pass.size(); ++i)
      travel_turns = std::max(travel_turns, angleBetween(wayTo(i - 1), wayTo(i)));
    EXPECT_LE(largestFrameTurn(moves).angle, travel_turns + 1e-9);
    for (const Eigen::Matrix3d& frame : toolFrames(moves[0]))
      ASSERT_GE(frame.col(0).x(), -1e-9);
    const std::vector<Eigen::Matrix3d> frames = toolFrames(moves[0], RobotZ::Normal); // x turns with the normal, and no more
    for (std::size_t i = 1; i < frames.size(); ++i)
      ASSERT_LE(angleBetween(frames[i - 1].col(0), frames[i].col(0)),
                travel_turns + angleBetween(frames[i - 1].col(2), frames[i].col(2)) + 1e-9);
  }
}

TEST(RobotFrames, KeepXWhereTheTipStandsOrMovesAlongZ)
{
  using Eigen::Vector3d;
  const auto pose = [](double x, double y, double z) { return ToolPose{{x, y, z}, Vector3d::UnitZ(), {x, y, z}, Vector3d::UnitZ()}; };
  // Along y; 5 mm up; on along y; rounded places at one spot, whose contact wanders; on along x.
  ToolPoses pass{pose(100, 0, 0), pose(100, 1, 0), pose(100, 1, 5), pose(100, 2, 5)};
  pass.push_back(pose(100.000001, 1.999999, 5));
  pass.push_back(pose(99.999999, 2.000001, 5));
  pass[4].contact.x() -= 2.0;
  pass.push_back(pose(101, 2, 5));
  pass.push_back(pose(102, 2, 5));
  const std::vector<ToolMoves> moves = ledPasses({pass}, {});
  const std::vector<Eigen::Matrix3d> frames = toolFrames(moves[0]);
  const auto first = static_cast<std::size_t>(
      std::find_if(moves[0].begin(), moves[0].end(), [](const ToolMove& m) { return m.section == BlockSection::Cut; }) - moves[0].begin() -
      1);
  for (std::size_t i = 0; i < first + 3; ++i)
    EXPECT_LT((frames[i].col(0) - Vector3d::UnitY()).norm(), 1e-6) << i;
  for (std::size_t i = first + 3; i < frames.size(); ++i)
    EXPECT_LT((frames[i].col(0) - Vector3d::UnitX()).norm(), 1e-5) << i;
  EXPECT_NEAR(largestFrameTurn(moves).angle, 0.5 * M_PI, 1e-5);
  EXPECT_LT((largestFrameTurn(moves).place - pass[3].tip).norm(), 1e-9);
}

TEST(RobotFrames, SpeedsGiveEachMoveItsTime)
{
  const ScratchFolder folder;
  const std::vector<ToolPoses> passes = testPasses(Eigen::Isometry3d::Identity());
  ProgramSettings settings;
  settings.feed = 1200.0; // 0.02 m/s
  const std::vector<ToolMoves> moves = ledPasses(passes, settings);
  for (const RobotZ kind : {RobotZ::Axis, RobotZ::Normal}) {
    writeRobotFrames(folder.path("a.yaml"), moves, kind);
    const YAML::Node segment = YAML::LoadFile(folder.path("a.yaml"))[0][0][2];
    double seconds = 0.0, expected = 0.0;
    std::size_t cuts = 0;
    for (std::size_t i = 0; i < segment.size(); ++i) {
      const std::string word = segment[i]["move"].as<std::string>();
      EXPECT_EQ(word == "rapid", moves[2][i].rapid);
      EXPECT_EQ(word == "rapid", !segment[i]["speed"]);
      if (word != "cut")
        continue;
      ++cuts;
      const Eigen::Vector3d way = waypointOf(segment[i]).translation() - waypointOf(segment[i - 1]).translation();
      seconds += way.norm() / segment[i]["speed"].as<double>();
      const ToolPose &a = moves[2][i - 1].pose, &b = moves[2][i].pose;
      expected += (b.contact - a.contact).norm() / 20.0;
      if (kind == RobotZ::Normal)
        EXPECT_NEAR(segment[i]["speed"].as<double>(), 0.02, 2e-9);
    }
    EXPECT_EQ(cuts, passes[2].size() - 1);
    EXPECT_NEAR(seconds / expected, 1.0, 1e-4);
  }
}

TEST(RobotFrames, PassesWithoutMovesAreRefused)
{
  const ScratchFolder folder;
  EXPECT_THROW(writeRobotFrames(folder.path("a.yaml"), {}), FileError);
  EXPECT_THROW(writeRobotFrames(folder.path("a.yaml"), {ToolMoves()}), FileError);
  EXPECT_EQ(folder.count(), 0U);
}

} // namespace robot_frames_test
