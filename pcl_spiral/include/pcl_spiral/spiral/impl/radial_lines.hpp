// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/spiral/impl/boundary_choice.h>
#include <pcl_spiral/spiral/impl/loop_check.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>

#include <cmath>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
RadialLines<PointT, PointNT>::check() const
{
  for (const double tolerance : {tolerance_, fit_tolerance_})
    if (!(tolerance > 0.0) || !std::isfinite(tolerance))
      return {StatusCode::InvalidArgument,
              Diagnostic("a tolerance is ", tolerance, " {mm}: set it above 0 ({setTolerance}, {setFitTolerance})")};
  for (const auto* point : {&center_, &start_point_})
    if (*point && !(*point)->allFinite())
      return {StatusCode::InvalidArgument, "the centre or start point is not finite: give a point, or clear it"};
  return Status::success();
}

template <typename PointT, typename PointNT>
Status
RadialLines<PointT, PointNT>::run()
{
  const ThreadLimit limit(this->getNumberOfThreads());
  if (const Status status = check(); !status.ok())
    return status;
  Surface::ConstPtr surface;
  if (const Status status = this->prepareSurface(surface, partOf(progress_, 0.0, 0.4)); !status.ok())
    return status;
  loops_ = given_loops_;
  BoundaryOptions options;
  options.progress = partOf(progress_, 0.4, 0.5, "boundaries");
  const Status loops_status = loops_.empty() ? findBoundaryLoops(*surface, options, loops_) : checkLoops(surface->graph(), loops_);
  if (!loops_status.ok())
    return loops_status;
  BoundaryChoice choice;
  if (const Status status = chooseBoundaries(loops_, mode_, choice); !status.ok())
    return status;
  if (choice.inner && center_)
    return {StatusCode::InvalidArgument, Diagnostic("a centre was given, ", Place(*center_),
                                                    ", but the surface has two boundaries: leave the centre out ({clearCenter}), "
                                                    "or ask for one boundary ({setBoundaryMode})")};
  const RadialLineRequest request{surface->fit(), *choice.rim,    choice.inner,
                                  center_,        start_point_,   method_,
                                  tolerance_,     fit_tolerance_, partOf(progress_, 0.5, 1.0, "radial lines")};
  return buildRadialLines(request, set_);
}

template <typename PointT, typename PointNT>
void
RadialLines<PointT, PointNT>::compute(std::vector<RadialLine>& lines)
{
  set_ = RadialLineSet();
  loops_.clear();
  lines.clear();
  if (this->computeBy("RadialLines", [&] { return run(); }))
    lines = std::move(set_.lines);
  else {
    set_ = RadialLineSet();
    loops_.clear();
  }
  set_.lines.clear();
}

template <typename PointT, typename PointNT>
void
RadialLines<PointT, PointNT>::compute(RadialLineSet& set)
{
  set = RadialLineSet();
  std::vector<RadialLine> lines;
  compute(lines);
  set = set_;
  set.lines = std::move(lines);
}

} // namespace pcl_spiral
