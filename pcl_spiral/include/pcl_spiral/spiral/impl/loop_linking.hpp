// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/spiral/impl/step_over_input.hpp>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>

#include <utility>

namespace pcl_spiral {

/** Ok, or an error if the given loops were made otherwise than the settings or the given field. */
template <typename PointT, typename PointNT>
Status
LoopLinking<PointT, PointNT>::checkGivenBasis() const
{
  const StepOverBasis basis = given_scallop_loops_.empty() ? StepOverBasis() : given_scallop_loops_.front().basis;
  if (const Status status = checkBasis(basis, {this->settings_.tool_radius, this->settings_.scallop_height}, "the set of loops");
      !status.ok() || !this->given_field_)
    return status;
  return checkBasis(basis, this->given_field_->basis, "the set of loops");
}

template <typename PointT, typename PointNT>
Status
LoopLinking<PointT, PointNT>::run(LinkedPath& path)
{
  const ProgressCallback& progress = this->progress_;
  const bool given = !given_scallop_loops_.empty(), nothing_else = !this->given_surface_ && !this->input_;
  if (const Status status = this->checkShared(); !status.ok())
    return status;
  if (given)
    for (const Status& status : {checkScallopLoops(given_scallop_loops_), checkGivenBasis()})
      if (!status.ok())
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
  figures_ = ScallopReport();
  this->warnings_.clear();
  const ThreadLimit limit(this->getNumberOfThreads());
  LinkedPath made;
  if (this->computeBy("LoopLinking", [&] { return run(made); }))
    path = std::move(made);
  else
    figures_ = ScallopReport();
}

} // namespace pcl_spiral
