// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>

#include <utility>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
BoundaryLoops<PointT, PointNT>::run(std::vector<BoundaryLoop>& loops)
{
  const ThreadLimit limit(this->getNumberOfThreads());
  Surface::ConstPtr surface;
  if (const Status status = this->prepareSurface(surface, partOf(progress_, 0.0, 0.6)); !status.ok())
    return status;
  BoundaryOptions options = options_;
  options.progress = partOf(progress_, 0.6, 1.0, "boundaries");
  if (boundary_points_) {
    if (boundary_points_->size() != surface->inputSize())
      return {StatusCode::InvalidInput, Diagnostic("there are ", boundary_points_->size(), " boundary flags for ", surface->inputSize(),
                                                   " points: call {setBoundaryPoints} with one a point, of the whole cloud")};
    options.marked.resize(surface->size());
    for (std::size_t i = 0; i < surface->size(); ++i) {
      const std::uint32_t original = surface->graph().blocks().originalIndex(i), in_cloud = surface->sourceIndex(i);
      options.marked[original] = in_cloud == Surface::no_source ? 0 : (*boundary_points_)[in_cloud].boundary_point;
    }
  }
  return findBoundaryLoops(*surface, options, loops, &counts_);
}

template <typename PointT, typename PointNT>
void
BoundaryLoops<PointT, PointNT>::compute(std::vector<BoundaryLoop>& loops)
{
  loops.clear();
  counts_ = BoundaryReport();
  std::vector<BoundaryLoop> found;
  if (this->computeBy("BoundaryLoops", [&] { return run(found); }))
    loops = std::move(found);
}

} // namespace pcl_spiral
