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
  this->computeBy("StepOverField", [&] { return this->makeField(surface, field, this->progress_); });
}

template <typename PointT, typename PointNT>
void
StepOverField<PointT, PointNT>::compute(StepOverDistance& field)
{
  field = StepOverDistance();
  StepOverDistance::ConstPtr made;
  compute(made);
  if (made)
    field = *made;
}

} // namespace pcl_spiral
