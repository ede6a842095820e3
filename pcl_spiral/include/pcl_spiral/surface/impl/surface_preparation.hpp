#pragma once

#include <pcl_spiral/search/usable_points.h>
#include <pcl_spiral/surface/surface_preparation.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp>

#include <cmath>
#include <string>

namespace pcl_spiral {

template <typename PointT>
Status
SurfacePreparation<PointT>::check() const
{
  if (!input_ || input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty; call setInputCloud with points"};
  if (outlier_neighbours_ < 0 || !(outlier_deviations_ > 0.0))
    return {StatusCode::InvalidArgument,
            "outlier removal by " + std::to_string(outlier_neighbours_) + " neighbours and " +
                std::to_string(outlier_deviations_) +
                " deviations; set 1 or more neighbours (0: off), deviations above 0"};
  if (!(thinning_ >= 0.0) || !std::isfinite(thinning_))
    return {StatusCode::InvalidArgument, "the voxel edge for thinning is " + std::to_string(thinning_) +
                                             "; set it above 0, or 0 for none"};
  if (graph_options_.neighbours < 8)
    return {StatusCode::InvalidArgument, "the number of neighbours is " +
                                             std::to_string(graph_options_.neighbours) +
                                             "; set it to 8 or more, 32 is recommended"};
  if (graph_options_.view_point && !graph_options_.view_point->allFinite())
    return {StatusCode::InvalidArgument, "the view point is not finite; set it to where the scanner stood"};
  return checkIndices(indices_.get(), input_->size());
}

template <typename PointT>
Status
SurfacePreparation<PointT>::select()
{
  UsablePoints usable = usablePoints(*input_, indices_.get());
  counts_.input = usable.asked_for;
  counts_.nonfinite = usable.nonfinite;
  counts_.duplicate = usable.duplicates;
  if (usable.source.empty())
    return {StatusCode::InvalidInput, "none of the " + std::to_string(counts_.input) +
                                          " points is finite; check the file they came from"};
  if (outlier_neighbours_ > 0)
    counts_.outlier = usable.keep(statisticalInliers(usable.positions, outlier_neighbours_, outlier_deviations_));
  if (thinning_ > 0.0) {
    const std::vector<std::uint32_t> kept = voxelRepresentatives(usable.positions, thinning_);
    if (kept.empty())
      return {StatusCode::InvalidArgument,
              "the voxel edge " + std::to_string(thinning_) +
                  " is under a millionth of the largest coordinate; make it larger"};
    counts_.thinned = usable.keep(kept);
  }
  counts_.used = usable.source.size();
  if (counts_.used < minimum_points)
    return {StatusCode::InvalidInput,
            std::to_string(counts_.used) + " points are left of " + std::to_string(counts_.input) +
                " (not finite " + std::to_string(counts_.nonfinite) + ", repeated " +
                std::to_string(counts_.duplicate) + ", outliers " + std::to_string(counts_.outlier) +
                ", thinned " + std::to_string(counts_.thinned) +
                "); a surface needs at least 50: give a denser scan or thin less"};
  source_indices_ = std::move(usable.source);
  return graph_.build(std::move(usable.positions), graph_options_);
}

template <typename PointT>
void
SurfacePreparation<PointT>::compute(PointCloud& cloud, pcl::PointCloud<pcl::Normal>& normals)
{
  counts_ = PreparationCounts();
  source_indices_.clear();
  graph_ = SurfaceGraph();
  status_ = check();
  if (status_.ok())
    status_ = select();
  if (!status_.ok()) {
    PCL_ERROR("[pcl_spiral::SurfacePreparation::compute] %s.\n", status_.message().c_str());
    source_indices_.clear();
    cloud.clear();
    normals.clear();
    return;
  }
  PointCloud kept;
  kept.header = input_->header;
  kept.reserve(graph_.size());
  normals.clear();
  normals.reserve(graph_.size());
  std::vector<std::uint32_t> source(graph_.size());
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    source[i] = source_indices_[graph_.blocks().originalIndex(i)];
    kept.push_back((*input_)[source[i]]);
    const Eigen::Vector3f& n = graph_.normals()[i];
    normals.push_back(pcl::Normal(n.x(), n.y(), n.z()));
  }
  source_indices_ = std::move(source);
  kept.is_dense = normals.is_dense = true;
  normals.header = kept.header;
  cloud = std::move(kept);
}

} // namespace pcl_spiral
