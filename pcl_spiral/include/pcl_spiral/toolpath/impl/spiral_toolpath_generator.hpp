/** \file
 *  SpiralToolpathGenerator: the PCL side. The work is SpiralPlanner's.
 */
#pragma once

#include <pcl_spiral/common/thread_limit.h>
#include <pcl_spiral/search/usable_points.h>
#include <pcl_spiral/toolpath/spiral_planner.h>
#include <pcl_spiral/toolpath/spiral_toolpath_generator.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp>

#include <cstdint>

namespace pcl_spiral {

template <typename PointInT, typename PointNT, typename PointOutT>
Status
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::collect(std::vector<Eigen::Vector3f>& points,
                                                               std::vector<Eigen::Vector3f>& normals)
{
  if (!this->input_)
    return {StatusCode::InvalidInput, "no input cloud: call setInputCloud"};
  const auto& cloud = *this->input_;
  if (cloud.empty())
    return {StatusCode::InvalidInput, "the input cloud is empty: check the file or the filters before this one"};
  if (normals_ && normals_->size() != cloud.size())
    return {StatusCode::InvalidArgument, "the cloud has " + std::to_string(cloud.size()) + " points but " +
                                             std::to_string(normals_->size()) + " normals were given; one a point"};
  if (const Status status = checkIndices(this->indices_.get(), cloud.size()); !status.ok())
    return status;
  UsablePoints usable = usablePoints(cloud, this->indices_.get());
  report_.input_points = usable.asked_for;
  report_.nonfinite_points = usable.nonfinite;
  report_.duplicate_points = usable.duplicates;
  if (settings_.outlier_neighbours > 0)
    report_.outlier_points =
        usable.keep(statisticalInliers(usable.positions, settings_.outlier_neighbours, settings_.outlier_deviations));
  if (settings_.thinning > 0.0) {
    const auto kept = voxelRepresentatives(usable.positions, settings_.thinning);
    if (kept.empty() && !usable.source.empty())
      return {StatusCode::InvalidArgument, "the thinning edge " + std::to_string(settings_.thinning) +
                                               " mm is too small for the size of the cloud: raise it, or check the units"};
    usable.keep(kept);
  }
  if (normals_)
    normals = normalsOf(*normals_, usable.source);
  points = std::move(usable.positions);
  report_.used_points = points.size();
  if (points.empty())
    return {StatusCode::InvalidInput, "none of the " + std::to_string(report_.input_points) +
                                          " points is finite: check the scan or the file's columns"};
  return Status::success();
}

template <typename PointInT, typename PointNT, typename PointOutT>
void
SpiralToolpathGenerator<PointInT, PointNT, PointOutT>::compute(pcl::PointCloud<PointOutT>& path)
{
  path.clear();
  report_ = SpiralReport();
  status_ = checkSettings(settings_);
  const ThreadLimit limit(settings_.threads);
  StageClock clock(report_.stages);
  std::vector<Eigen::Vector3f> points, normals;
  if (status_.ok())
    status_ = collect(points, normals);
  clock.end("points");
  SpiralPath spiral;
  if (status_.ok())
    status_ = SpiralPlanner(settings_, progress_, report_, clock).plan(std::move(points), std::move(normals), spiral);
  if (!status_.ok()) {
    if (status_.code() != StatusCode::Cancelled)
      PCL_ERROR("[pcl_spiral::SpiralToolpathGenerator::compute] %s\n", status_.message().c_str());
    return;
  }
  path.resize(spiral.contacts.size());
  const auto count = static_cast<std::int64_t>(path.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i) {
    PointOutT& p = path[i];
    p.getVector3fMap() = spiral.contacts[i].template cast<float>();
    p.getNormalVector3fMap() = spiral.normals[i].template cast<float>();
    p.getAxisVector3fMap() = spiral.axes[i];
    p.arc_length = spiral.arc_lengths[i];
    p.turn = spiral.turns[i];
    p.over_gap = spiral.over_gap[i];
  }
  path.header = this->input_->header;
  path.is_dense = true;
  clock.end("path");
}

} // namespace pcl_spiral
