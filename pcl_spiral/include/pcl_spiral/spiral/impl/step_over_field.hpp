// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/spiral/impl/step_over_input.hpp>
#include <pcl_spiral/spiral/step_over_field.h>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
void
StepOverField<PointT, PointNT>::compute(StepOverDistance::ConstPtr& field)
{
  field.reset();
  this->warnings_.clear();
  const ThreadLimit limit(this->getNumberOfThreads());
  Surface::ConstPtr surface;
  this->status_ = this->makeField(surface, field, this->progress_);
  this->tellFailure("StepOverField");
}

template <typename PointT, typename PointNT>
void
StepOverField<PointT, PointNT>::compute(StepOverDistance& field)
{
  StepOverDistance::ConstPtr made;
  compute(made);
  field = made ? *made : StepOverDistance();
}

} // namespace pcl_spiral
