#pragma once

#include <pcl_spiral/features/boundary_loops.h>

#include <pcl/common/point_tests.h>
#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled

#include <algorithm>
#include <string>
#include <tuple>

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
  if (indices_)
    for (const auto index : *indices_)
      if (index < 0 || static_cast<std::size_t>(index) >= input_->size())
        return {StatusCode::InvalidInput, "index " + std::to_string(index) + " is outside the cloud of " +
                                              std::to_string(input_->size()) + " points"};
  return Status::success();
}

/** Finite points that take part, each place once. */
template <typename PointT, typename PointNT>
std::vector<std::uint32_t>
BoundaryLoops<PointT, PointNT>::usablePoints() const
{
  std::vector<std::uint8_t> wanted(input_->size(), indices_ ? 0 : 1);
  if (indices_)
    for (const auto index : *indices_)
      wanted[static_cast<std::size_t>(index)] = 1;
  std::vector<std::uint32_t> usable;
  for (std::size_t i = 0; i < input_->size(); ++i)
    if (wanted[i] && pcl::isXYZFinite((*input_)[i]))
      usable.push_back(static_cast<std::uint32_t>(i));
  const auto key = [&](std::uint32_t i) {
    const PointT& p = (*input_)[i];
    return std::make_tuple(p.x, p.y, p.z);
  };
  std::sort(usable.begin(), usable.end(),
            [&](auto a, auto b) { return std::make_tuple(key(a), a) < std::make_tuple(key(b), b); });
  usable.erase(std::unique(usable.begin(), usable.end(), [&](auto a, auto b) { return key(a) == key(b); }),
               usable.end());
  std::sort(usable.begin(), usable.end());
  return usable;
}

template <typename PointT, typename PointNT>
Status
BoundaryLoops<PointT, PointNT>::buildGraph(const std::vector<std::uint32_t>& usable, SurfaceGraph& graph) const
{
  std::vector<Eigen::Vector3f> points;
  points.reserve(usable.size());
  for (const std::uint32_t i : usable)
    points.push_back((*input_)[i].getVector3fMap());
  SurfaceGraphOptions options;
  options.max_circumradius = alpha_;
  Status status = graph.build(points, options);
  if (!status.ok() || !normals_)
    return status;
  double agreement = 0.0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const PointNT& given = (*normals_)[usable[graph.blocks().originalIndex(i)]];
    if (pcl::isNormalFinite(given))
      agreement += graph.normal(i).dot(given.getNormalVector3fMap().template cast<double>());
  }
  if (agreement >= 0.0)
    return status;
  options.flip_normals = true;
  return graph.build(points, options);
}

template <typename PointT, typename PointNT>
void
BoundaryLoops<PointT, PointNT>::compute(std::vector<BoundaryLoop>& loops)
{
  loops.clear();
  counts_ = BoundaryCounts();
  status_ = check();
  std::vector<std::uint32_t> usable;
  SurfaceGraph graph;
  if (status_.ok()) {
    usable = usablePoints();
    status_ = buildGraph(usable, graph);
  }
  if (status_.ok()) {
    BoundaryOptions options = options_;
    if (boundary_points_)
      for (const std::uint32_t i : usable)
        options.marked.push_back((*boundary_points_)[i].boundary_point);
    status_ = findBoundaryLoops(graph, options, loops, &counts_);
  }
  if (!status_.ok())
    PCL_ERROR("[pcl_spiral::BoundaryLoops::compute] %s.\n", status_.message().c_str());
  for (BoundaryLoop& loop : loops)
    for (std::uint32_t& index : loop.indices)
      index = usable[index];
}

} // namespace pcl_spiral
