// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/spiral/impl/boundary_choice.h>
#include <pcl_spiral/spiral/impl/constant_scallop.h>
#include <pcl_spiral/spiral/impl/loop_check.h>
#include <pcl_spiral/spiral/impl/settings_check.h>
#include <pcl_spiral/spiral/impl/step_over_input.h>
#include <pcl_spiral/spiral/step_over_field.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
StepOverInput<PointT, PointNT>::makeField(Surface::ConstPtr& surface, std::shared_ptr<const StepOverDistance>& field,
                                          const ProgressCallback& progress)
{
  if (const Status status = checkSettings(settings_); !status.ok())
    return status;
  if (const Status status = this->prepareSurface(surface, partOf(progress, 0.0, 0.4)); !status.ok())
    return status;
  if (const Status status = checkScale(*surface, settings_, warnings_); !status.ok())
    return status;
  std::vector<BoundaryLoop> loops = given_loops_;
  BoundaryOptions options;
  options.progress = partOf(progress, 0.4, 0.5, "boundaries");
  const Status found = loops.empty() ? findBoundaryLoops(*surface, options, loops) : checkLoops(surface->graph(), loops);
  if (!found.ok())
    return found;
  BoundaryChoice choice;
  if (const Status status = chooseBoundaries(loops, BoundaryMode::AllBoundaries, choice); !status.ok())
    return status;
  const auto made = std::make_shared<StepOverDistance>();
  const Status status = makeStepOverField(*surface, loops, settings_, partOf(progress, 0.5, 1.0), *made);
  if (status.ok())
    field = made;
  return status;
}

template <typename PointT, typename PointNT>
Status
FieldInput<PointT, PointNT>::takeField(Surface::ConstPtr& surface, FieldConstPtr& field, const ProgressCallback& progress)
{
  if (!given_field_)
    return this->makeField(surface, field, progress);
  if (const Status status = this->checkShared(); !status.ok())
    return status;
  field = given_field_;
  if (const Status status = checkBasis(field->basis, {this->settings_.tool_radius, this->settings_.scallop_height}, "the field");
      !status.ok())
    return status;
  return checkField(*field);
}

} // namespace pcl_spiral
