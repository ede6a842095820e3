// SPDX-License-Identifier: BSD-3-Clause
// pcl_spiral_drive --mesh from outside: the tolerance is also kept on walls.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"
#include "support/filleted_parts.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace mesh_drive_test {

namespace {

using namespace pcl_spiral::test;

class MeshDrive : public ::testing::Test {
protected:
  RunResult run(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), {"part.stl", "--mesh", "-o", "a.csv"});
    return endOf(startProgram(PCL_SPIRAL_DRIVE_PROGRAM, arguments, folder_), folder_);
  }

  ScratchFolder folder_;
};

} // namespace

TEST_F(MeshDrive, NoVertexIsDeeperInABallThanTheTolerance)
{
  const TriangleMesh mesh = ruggedMesh(3);
  writeStl(folder_.path("part.stl"), mesh);
  for (const double tolerance : {0.01, 0.001}) {
    const RunResult result = run({"--step-over", "0.4", "--tool-radius", "0.6", "--tolerance", std::to_string(tolerance)});
    ASSERT_EQ(result.code, 0) << result.err;
    double deepest = 0.0;
    for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path) {
      const Eigen::Vector3d middle = (p.getVector3fMap() + 0.6f * p.getNormalVector3fMap()).cast<double>();
      for (const Eigen::Vector3d& v : mesh.vertices)
        deepest = std::max(deepest, 0.6 - (v - middle).norm());
    }
    EXPECT_LT(deepest, tolerance + 1e-5);
  }
}

TEST_F(MeshDrive, ToleranceIsRefusedWhereItIsMuchOfTheCutter)
{
  writeStl(folder_.path("part.stl"), ruggedMesh(3));
  const RunResult refused = run({"--step-over", "0.4", "--tool-radius", "0.06"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("--tolerance 0.01: must be at most a tenth of the tool radius of 0.06 mm, such as 0.0006"), std::string::npos)
      << refused.err;
  EXPECT_EQ(run({"--step-over", "0.4", "--tool-radius", "0.06", "--tolerance", "0.0006"}).code, 0);
}

/** A groove 6 mm wide and 5 mm deep, with walls straight down: a ball leaves (sqrt(2) - 1) R in its corners, whatever the rows are. */
TEST_F(MeshDrive, CornersLeaveWhatTheMessageSaysAndItsRemediesWork)
{
  using Eigen::Vector2d;
  constexpr double radius = 1.0;
  const RoundedProfile groove(
      {{Vector2d(-12, 0)}, {Vector2d(-3, 0)}, {Vector2d(-3, -5)}, {Vector2d(3, -5)}, {Vector2d(3, 0)}, {Vector2d(12, 0)}}, 10.0);
  SweepGuide line;
  line.half = {0.0, 10.0};
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned.linear() = Eigen::AngleAxisd(0.23, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  writeStl(folder_.path("part.stl"), placedPart(sweptPart(groove, line), turned).mesh);
  const RunResult refused = run({"--tool-radius", "1", "--scallop", "0.05"});
  ASSERT_EQ(refused.code, 1) << refused.out;
  const auto numberAfter = [&](const std::string& words) {
    const std::size_t at = refused.err.find(words);
    EXPECT_NE(at, std::string::npos) << words << " in " << refused.err;
    return at == std::string::npos ? 0.0 : std::strtod(refused.err.c_str() + at + words.size(), nullptr);
  };
  EXPECT_NEAR(numberAfter("up to "), (std::sqrt(2.0) - 1.0) * radius, 0.05) << refused.err;
  EXPECT_EQ(run({"--tool-radius", "1", "--step-over", std::to_string(numberAfter("give --step-over "))}).code, 0);
  // Contacts at walls and edges have the normals of the ball, and the judge agrees.
  for (const auto& p : pcl_spiral::readToolpath(folder_.path("a.csv")).path)
    EXPECT_NEAR(p.getNormalVector3fMap().norm(), 1.0, 1e-4);
  const RunResult judged =
      endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM, {"part.stl", "a.csv", "--mesh", "--tool-radius", "1", "--max-gouge", "0.02"}, folder_),
            folder_);
  EXPECT_EQ(judged.code, 0) << judged.out << judged.err;
  EXPECT_EQ(judged.out.find("wrong tips"), std::string::npos) << judged.out;
}

} // namespace mesh_drive_test
