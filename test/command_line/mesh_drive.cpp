// SPDX-License-Identifier: BSD-3-Clause
// pcl_spiral_drive --mesh from outside: the tolerance is also kept on walls.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace pcl_spiral::test;

class MeshDrive : public ::testing::Test {
protected:
  RunResult run(std::vector<std::string> arguments)
  {
    arguments.insert(arguments.begin(), {"part.stl", "--mesh", "-o", "a.csv", "--step-over", "0.4"});
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
    const RunResult result = run({"--tool-radius", "0.6", "--tolerance", std::to_string(tolerance)});
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
  const RunResult refused = run({"--tool-radius", "0.06"});
  EXPECT_EQ(refused.code, 2);
  EXPECT_NE(refused.err.find("--tolerance 0.01: must be at most a tenth of the tool radius of 0.06 mm, such as 0.0006"), std::string::npos)
      << refused.err;
  EXPECT_EQ(run({"--tool-radius", "0.06", "--tolerance", "0.0006"}).code, 0);
}
