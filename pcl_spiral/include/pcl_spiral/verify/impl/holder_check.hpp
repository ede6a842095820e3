// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/verify/holder_check.h>

#include <algorithm>

namespace pcl_spiral {

template <typename PointT>
template <typename MakeRuns>
Status
HolderCheck<PointT>::find(MakeRuns make_runs)
{
  for (const Status& status : {mesh_ ? Status::success() : this->checkCloud(), this->checkTool()})
    if (!status.ok())
      return status;
  const UpperTool tool = upperTool(this->getCutter(), this->getHolder(), this->getHolderClearance());
  CutRuns runs;
  if (const Status status = make_runs(tool, runs); !status.ok())
    return status;
  const auto look = [&](const auto& obstacles, LeadReport& figures) {
    return findHolderCollisions(obstacles, tool, runs, this->getTolerance(), this->progress(), figures);
  };
  if (!mesh_)
    return this->findAmongPoints(look);
  const ThreadLimit limit(this->getNumberOfThreads());
  const Status status = look(*mesh_, this->figures_);
  this->obstacle_figures_ = this->figures_;
  return status;
}

template <typename PointT>
void
HolderCheck<PointT>::compute(const std::vector<ToolPoses>& passes)
{
  this->report("HolderCheck", [&] { return find([&](const UpperTool&, CutRuns& runs) { return cutRuns(passes, runs); }); });
}

template <typename PointT>
void
HolderCheck<PointT>::compute(const MachineProgram& program)
{
  constexpr double share = 0.25;      // of the tolerance: the way between two places is that straight
  constexpr double longest_arm = 1e3; // mm, of a shank without an end
  this->report("HolderCheck", [&] {
    return find([&](const UpperTool& tool, CutRuns& runs) {
      return cutRuns(program, std::min(longest_arm, tool.top()), share * this->getTolerance(), runs);
    });
  });
}

} // namespace pcl_spiral
