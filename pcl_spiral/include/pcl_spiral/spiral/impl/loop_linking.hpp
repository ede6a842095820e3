// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/spiral/impl/step_over_input.hpp>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>

#include <utility>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
LoopLinking<PointT, PointNT>::run(LinkedPath& path)
{
  const ProgressCallback& progress = this->progress_;
  const bool given = !given_scallop_loops_.empty(), nothing_else = !this->given_surface_ && !this->input_;
  if (const Status status = this->checkShared(); !status.ok())
    return status;
  if (given)
    if (const Status status = checkScallopLoops(given_scallop_loops_); !status.ok())
      return status;
  StepOverDistance::ConstPtr field;
  if (!given || this->given_field_ || !nothing_else) {
    Surface::ConstPtr surface;
    if (const Status status = this->takeField(surface, field, partOf(progress, 0.0, 0.5)); !status.ok())
      return status;
  }
  ScallopLoopSet set;
  if (given)
    set.loops = given_scallop_loops_;
  else if (!makeScallopLoops(*field, partOf(progress, 0.5, 0.8), set))
    return {StatusCode::Cancelled, "cancelled"};
  figures_.fingers = set.axes.size();
  std::vector<StageCost> costs;
  StageClock clock(costs);
  return makeScallopPath(std::move(set.loops), field.get(), this->settings_, partOf(progress, 0.8, 1.0), clock, path, figures_);
}

template <typename PointT, typename PointNT>
void
LoopLinking<PointT, PointNT>::compute(LinkedPath& path)
{
  path = LinkedPath();
  figures_ = ScallopFigures();
  this->warnings_.clear();
  const ThreadLimit limit(this->getNumberOfThreads());
  this->status_ = run(path);
  if (!this->status_.ok()) {
    path = LinkedPath();
    figures_ = ScallopFigures();
  }
  this->tellFailure("LoopLinking");
}

} // namespace pcl_spiral
