// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/spiral/impl/settings_check.h>
#include <pcl_spiral/spiral/impl/step_over_input.hpp>
#include <pcl_spiral/spiral/scallop_loops.h>

#include <utility>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
ScallopLoops<PointT, PointNT>::run(Surface::ConstPtr& surface, const ProgressCallback& progress, ScallopLoopSet& set)
{
  StepOverDistance::ConstPtr field;
  if (const Status status = this->takeField(surface, field, partOf(progress, 0.0, 0.6)); !status.ok())
    return status;
  if (!makeScallopLoops(*field, partOf(progress, 0.6, 1.0), set))
    return {StatusCode::Cancelled, "cancelled"};
  return Status::success();
}

template <typename PointT, typename PointNT>
Status
ScallopLoops<PointT, PointNT>::runPasses(DrivePasses& passes)
{
  if (const Status status = checkSettings(this->settings_); !status.ok())
    return status;
  Surface::ConstPtr surface;
  if (this->given_field_) // the surface is needed in this case too
    if (const Status status = this->prepareSurface(surface, partOf(this->progress_, 0.0, 0.3)); !status.ok())
      return status;
  ScallopLoopSet set;
  if (const Status status = run(surface, partOf(this->progress_, 0.3, 0.8), set); !status.ok())
    return status;
  return putLoopsOnSurface(set.loops, *surface, this->settings_, partOf(this->progress_, 0.8, 1.0), passes);
}

template <typename PointT, typename PointNT>
void
ScallopLoops<PointT, PointNT>::compute(ScallopLoopSet& set)
{
  set = ScallopLoopSet();
  this->warnings_.clear();
  const ThreadLimit limit(this->getNumberOfThreads());
  Surface::ConstPtr surface;
  ScallopLoopSet made;
  if (this->computeBy("ScallopLoops", [&] { return run(surface, this->progress_, made); }))
    set = std::move(made);
}

template <typename PointT, typename PointNT>
void
ScallopLoops<PointT, PointNT>::compute(DrivePasses& passes)
{
  passes.clear();
  this->warnings_.clear();
  const ThreadLimit limit(this->getNumberOfThreads());
  DrivePasses made;
  if (this->computeBy("ScallopLoops", [&] { return runPasses(made); }))
    passes = std::move(made);
}

} // namespace pcl_spiral
