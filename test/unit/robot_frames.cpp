// SPDX-License-Identifier: BSD-3-Clause
// Robot frames read back by yaml-cpp in the way of noether: nested sequences of maps, each key by its name.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>

#include "support/dome_spiral.h"
#include "support/random_vectors.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

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
          Eigen::Vector3d travel = passes[k][from + 1].contact - passes[k][from].contact;
          travel -= travel.dot(z) * z;
          ASSERT_LT((frame.col(0) - travel.normalized()).norm(), 1e-6) << k << " " << i;
        }
      }
    }
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
