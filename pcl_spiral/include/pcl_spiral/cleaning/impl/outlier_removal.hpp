// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/cleaning/impl/clean_graph.h>
#include <pcl_spiral/cleaning/impl/point_groups.h>
#include <pcl_spiral/cleaning/outlier_removal.h>
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/search/impl/usable_points.h>

#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/impl/pcl_base.hpp>

#include <algorithm>
#include <cstdint>

namespace pcl_spiral {

/** The places of the outliers to leave out, in order; counts them. */
template <typename PointT>
std::vector<std::array<float, 3>>
OutlierRemoval<PointT>::placesToLeaveOut(const std::vector<Eigen::Vector3f>& outliers, double reach)
{
  const std::vector<std::uint32_t> group = pointGroups(outliers, reach);
  std::vector<std::size_t> sizes;
  std::vector<Eigen::Vector3d> sums;
  for (std::size_t i = 0; i < outliers.size(); ++i) {
    if (group[i] == sizes.size()) {
      sizes.push_back(0);
      sums.push_back(Eigen::Vector3d::Zero());
    }
    ++sizes[group[i]];
    sums[group[i]] += outliers[i].cast<double>();
  }
  for (std::size_t g = 0; g < sizes.size(); ++g)
    if (sizes[g] > figures_.largest_group) {
      figures_.largest_group = sizes[g];
      figures_.largest_group_place = sums[g] / static_cast<double>(sizes[g]);
    }
  std::vector<std::array<float, 3>> places;
  for (std::size_t i = 0; i < outliers.size(); ++i)
    if (largest_group_ == 0 || sizes[group[i]] <= largest_group_)
      places.push_back({outliers[i].x(), outliers[i].y(), outliers[i].z()});
    else
      ++figures_.kept_outliers;
  std::sort(places.begin(), places.end());
  return places;
}

template <typename PointT>
Status
OutlierRemoval<PointT>::choose(pcl::Indices& kept, pcl::Indices& removed)
{
  constexpr double spacings = 3.0; // between connected outliers
  if (const Status status = checkThreads(thread_count_); !status.ok())
    return status;
  const ThreadLimit limit(thread_count_);
  const auto& cloud = *this->input_;
  if (const Status status = checkIndices(this->indices_.get(), cloud.size()); !status.ok())
    return status;
  std::vector<Eigen::Vector3f> positions = usablePoints(cloud, this->indices_.get()).positions;
  SurfaceGraph graph;
  GraphSource source;
  if (const Status status = buildCleanGraph(positions, SurfaceGraphOptions(), graph, source); !status.ok())
    return status;
  std::vector<Eigen::Vector3f> outliers;
  for (const std::uint32_t i : source.outliers)
    outliers.push_back(positions[i]);
  // A duplicate of an outlier is an outlier too: places are compared.
  const std::vector<std::array<float, 3>> places = placesToLeaveOut(outliers, spacings * graph.spacing());
  for (const auto index : *this->indices_) {
    const PointT& p = cloud[static_cast<std::size_t>(index)];
    const bool finite = pcl::isFinite(p);
    const bool is_outlier = finite && std::binary_search(places.begin(), places.end(), std::array<float, 3>{p.x, p.y, p.z});
    figures_.nonfinite += !finite;
    figures_.outliers += is_outlier;
    (is_outlier || !finite ? removed : kept).push_back(index);
  }
  return Status::success();
}

} // namespace pcl_spiral
