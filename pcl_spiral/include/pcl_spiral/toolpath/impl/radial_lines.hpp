#pragma once

#include <pcl_spiral/common/thread_limit.h>
#include <pcl_spiral/features/surface_boundary.h>
#include <pcl_spiral/search/usable_points.h>
#include <pcl_spiral/toolpath/boundary_choice.h>
#include <pcl_spiral/toolpath/loop_check.h>
#include <pcl_spiral/toolpath/radial_lines.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled

#include <cmath>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
RadialLines<PointT, PointNT>::check() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call setInputCloud with points"};
  if (normals_ && normals_->size() != input_->size())
    return {StatusCode::InvalidInput, "there are " + std::to_string(normals_->size()) + " normals for " +
                                          std::to_string(input_->size()) + " points; give one a point"};
  if (const Status status = checkIndices(indices_.get(), input_->size()); !status.ok())
    return status;
  for (const double tolerance : {tolerance_, fit_tolerance_})
    if (!(tolerance > 0.0) || !std::isfinite(tolerance))
      return {StatusCode::InvalidArgument, "a tolerance is " + std::to_string(tolerance) + " mm; set it above 0"};
  for (const auto* point : {&center_, &start_point_})
    if (*point && !(*point)->allFinite())
      return {StatusCode::InvalidArgument, "the centre or start point is not finite; give a point, or clear it"};
  if (thread_count_ < 0)
    return {StatusCode::InvalidArgument, "the number of threads is " + std::to_string(thread_count_) +
                                             "; set 0 for all, or a count"};
  return Status::success();
}

template <typename PointT, typename PointNT>
Status
RadialLines<PointT, PointNT>::run()
{
  if (const Status status = check(); !status.ok())
    return status;
  const ThreadLimit limit(thread_count_);
  const UsablePoints usable = usablePoints(*input_, indices_.get());
  SurfaceGraphOptions options;
  if (normals_)
    options.given_normals = normalsOf(*normals_, usable.source);
  SurfaceGraph graph;
  if (const Status status = graph.build(usable.positions, options); !status.ok())
    return status;
  const MlsSurface surface(graph);
  loops_ = given_loops_;
  const Status loops_status =
      loops_.empty() ? findBoundaryLoops(surface, BoundaryOptions(), loops_) : checkLoops(graph, loops_);
  if (!loops_status.ok())
    return loops_status;
  BoundaryChoice choice;
  if (const Status status = chooseBoundaries(loops_, mode_, choice); !status.ok())
    return status;
  if (choice.inner && center_)
    return {StatusCode::InvalidArgument,
            "a centre was given, but lines between two boundaries have none; clear it, or ask for one boundary"};
  RadialLineRequest request{surface,      *choice.rim, choice.inner, center_,        start_point_,
                            method_,      tolerance_,  fit_tolerance_, progress_};
  return buildRadialLines(request, set_);
}

template <typename PointT, typename PointNT>
void
RadialLines<PointT, PointNT>::compute(std::vector<RadialLine>& lines)
{
  set_ = RadialLineSet();
  loops_.clear();
  lines.clear();
  status_ = run();
  if (status_.ok())
    lines = std::move(set_.lines);
  else if (status_.code() != StatusCode::Cancelled)
    PCL_ERROR("[pcl_spiral::RadialLines::compute] %s.\n", status_.message().c_str());
  set_.lines.clear();
}

} // namespace pcl_spiral
