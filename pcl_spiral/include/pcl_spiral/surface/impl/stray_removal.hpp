#pragma once

#include <pcl_spiral/search/usable_points.h>
#include <pcl_spiral/surface/clean_graph.h>
#include <pcl_spiral/surface/stray_removal.h>

#include <pcl/console/print.h>
#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/impl/pcl_base.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace pcl_spiral {

template <typename PointT>
Status
StrayRemoval<PointT>::choose(pcl::Indices& kept, pcl::Indices& removed) const
{
  const auto& cloud = *this->input_;
  if (const Status status = checkIndices(this->indices_.get(), cloud.size()); !status.ok())
    return status;
  UsablePoints usable = usablePoints(cloud, this->indices_.get());
  SurfaceGraph graph;
  GraphSource source;
  if (const Status status = buildCleanGraph(std::move(usable.positions), SurfaceGraphOptions(), graph, source); !status.ok())
    return status;
  // A repetition of a stray is one as well: places are compared.
  const auto placeOf = [&cloud](std::size_t i) { return std::array<float, 3>{cloud[i].x, cloud[i].y, cloud[i].z}; };
  std::vector<std::array<float, 3>> strays;
  for (const std::uint32_t stray : source.strays)
    strays.push_back(placeOf(usable.source[stray]));
  std::sort(strays.begin(), strays.end());
  for (const auto index : *this->indices_) {
    const auto i = static_cast<std::size_t>(index);
    const bool off = !pcl::isFinite(cloud[i]) || std::binary_search(strays.begin(), strays.end(), placeOf(i));
    (off ? removed : kept).push_back(index);
  }
  return Status::success();
}

template <typename PointT>
void
StrayRemoval<PointT>::applyFilter(pcl::Indices& indices)
{
  pcl::Indices kept, removed;
  status_ = choose(kept, removed);
  if (!status_.ok())
    PCL_ERROR("[pcl_spiral::StrayRemoval::filter] %s\n", status_.message().c_str());
  if (this->negative_)
    kept.swap(removed);
  indices = std::move(kept);
  if (this->extract_removed_indices_)
    *this->removed_indices_ = std::move(removed);
}

} // namespace pcl_spiral
