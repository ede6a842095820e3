// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/holder_check_engine.h>

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/machine/impl/sampled_moves.h>

#include <cmath>

namespace pcl_spiral {
namespace {

bool
isUsable(const ToolPose& pose)
{
  return pose.tip.allFinite() && std::abs(pose.axis.norm() - 1.0) < 1e-6;
}

} // namespace

Status
cutRuns(const std::vector<ToolPoses>& passes, CutRuns& runs)
{
  runs = CutRuns();
  std::size_t number = 0;
  for (const ToolPoses& poses : passes) {
    for (const ToolPose& pose : poses) {
      if (!isUsable(pose))
        return {StatusCode::InvalidInput, Diagnostic("pose ", number, " is not finite or its axis is not a unit vector; remove it")};
      runs.moves.push_back(number++);
    }
    runs.count += poses.empty() ? 0 : poses.size() - 1;
  }
  runs.runs = passes;
  if (runs.count == 0)
    return {StatusCode::InvalidInput, "no pass has a move; give at least two poses"};
  return Status::success();
}

Status
cutRuns(const MachineProgram& program, double arm, double tolerance, CutRuns& runs)
{
  runs = CutRuns();
  if (const Status status = checkMachine(program.machine); !status.ok())
    return status;
  const Kinematics kinematics(program.machine);
  const MoveSampling sampling{arm, tolerance, false, true};
  const std::vector<ProgramBlock>& blocks = program.blocks;
  const auto cuts = [&](std::size_t i) { return i > 0 && blocks[i].section == BlockSection::Cut && !blocks[i].rapid; };
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    if (!cuts(i))
      continue;
    if (!cuts(i - 1)) {
      runs.runs.push_back({poseOf(blocks[i - 1])});
      runs.moves.push_back(i);
    }
    for (const ToolPose& pose : sampledMove(kinematics, blocks[i - 1], blocks[i], sampling)) {
      runs.runs.back().push_back(pose);
      runs.moves.push_back(i);
    }
    ++runs.count;
  }
  if (runs.count == 0)
    return {StatusCode::InvalidInput, "the program has no cutting moves; make it first with {MachineProgramGenerator}"};
  return Status::success();
}

} // namespace pcl_spiral
