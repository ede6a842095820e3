#pragma once

#include <pcl_spiral/features/boundary_loops.h>

#include <pcl/common/point_tests.h>
#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled

#include <string>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
BoundaryLoops<PointT, PointNT>::check() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call setInputCloud with points"};
  if (!(alpha_ >= 1.0))
    return {StatusCode::InvalidArgument, "alpha is " + std::to_string(alpha_) +
                                             " spacings; below 1 the surface falls apart; 3 is usual"};
  if (normals_ && normals_->size() != input_->size())
    return {StatusCode::InvalidInput, "there are " + std::to_string(normals_->size()) + " normals for " +
                                          std::to_string(input_->size()) +
                                          " points; call setInputNormals with one a point"};
  if (boundary_points_ && boundary_points_->size() != input_->size())
    return {StatusCode::InvalidInput, "there are " + std::to_string(boundary_points_->size()) + " boundary flags for " +
                                          std::to_string(input_->size()) +
                                          " points; call setBoundaryPoints with one a point, of the whole input"};
  return checkIndices(indices_.get(), input_->size());
}

template <typename PointT, typename PointNT>
Status
BoundaryLoops<PointT, PointNT>::buildGraph(const UsablePoints& usable, SurfaceGraph& graph) const
{
  SurfaceGraphOptions options;
  options.max_circumradius = alpha_;
  Status status = graph.build(usable.positions, options);
  if (!status.ok() || !normals_)
    return status;
  double agreement = 0.0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const PointNT& given = (*normals_)[usable.source[graph.blocks().originalIndex(i)]];
    if (pcl::isNormalFinite(given))
      agreement += graph.normal(i).dot(given.getNormalVector3fMap().template cast<double>());
  }
  if (agreement >= 0.0)
    return status;
  options.flip_normals = true;
  return graph.build(usable.positions, options);
}

template <typename PointT, typename PointNT>
void
BoundaryLoops<PointT, PointNT>::compute(std::vector<BoundaryLoop>& loops)
{
  loops.clear();
  counts_ = BoundaryCounts();
  status_ = check();
  UsablePoints usable;
  SurfaceGraph graph;
  if (status_.ok()) {
    usable = usablePoints(*input_, indices_.get());
    status_ = buildGraph(usable, graph);
  }
  if (status_.ok()) {
    BoundaryOptions options = options_;
    if (boundary_points_)
      for (const std::uint32_t i : usable.source)
        options.marked.push_back((*boundary_points_)[i].boundary_point);
    status_ = findBoundaryLoops(graph, options, loops, &counts_);
  }
  if (!status_.ok())
    PCL_ERROR("[pcl_spiral::BoundaryLoops::compute] %s.\n", status_.message().c_str());
  for (BoundaryLoop& loop : loops)
    for (std::uint32_t& index : loop.indices)
      index = usable.source[index];
}

} // namespace pcl_spiral
