// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>

#include <utility>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
GapBridging<PointT, PointNT>::run(BridgedSurface& bridged)
{
  const ThreadLimit limit(this->getNumberOfThreads());
  Surface::ConstPtr surface;
  if (const Status status = this->prepareSurface(surface, partOf(progress_, 0.0, 0.5)); !status.ok())
    return status;
  std::vector<BoundaryLoop> loops = given_loops_;
  BoundaryOptions options;
  options.min_hole_width = options_.hole_size;
  options.progress = partOf(progress_, 0.5, 0.75, "boundaries");
  if (loops.empty())
    if (const Status status = findBoundaryLoops(*surface, options, loops); !status.ok())
      return status;
  return bridgeGaps(std::move(surface), loops, options_, partOf(progress_, 0.75, 1.0), bridged,
                    given_loops_.empty() ? LoopOrigin::Found : LoopOrigin::Given);
}

template <typename PointT, typename PointNT>
void
GapBridging<PointT, PointNT>::compute(BridgedSurface& bridged)
{
  bridged = BridgedSurface();
  BridgedSurface made;
  if (this->computeBy("GapBridging", [&] { return run(made); }))
    bridged = std::move(made);
  gaps_ = bridged.gaps;
  warnings_ = bridged.warnings;
}

template <typename PointT, typename PointNT>
void
GapBridging<PointT, PointNT>::compute(Surface::ConstPtr& surface, std::vector<BoundaryLoop>& loops)
{
  surface.reset();
  loops.clear();
  BridgedSurface bridged;
  compute(bridged);
  surface = bridged.surface;
  loops = std::move(bridged.loops);
}

} // namespace pcl_spiral
