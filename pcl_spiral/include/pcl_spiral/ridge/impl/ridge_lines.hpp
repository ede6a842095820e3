// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/ridge/ridge_lines.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>

namespace pcl_spiral {
namespace detail {

template <typename PointT>
void
toCloud(const Polyline& line, pcl::PointCloud<PointT>& cloud)
{
  cloud.clear();
  for (const Eigen::Vector3d& p : line) {
    PointT point;
    point.getVector3fMap() = p.cast<float>();
    cloud.push_back(point);
  }
}

} // namespace detail

template <typename PointT>
Status
RidgeLines<PointT>::run()
{
  constexpr double surface_share = 0.4; // of the time
  if (const Status status = this->checkInput(); !status.ok())
    return status;
  const ThreadLimit limit(this->getNumberOfThreads());
  if (const Status status = checkScanRidgeSettings(settings_); !status.ok())
    return status;
  Surface::ConstPtr surface;
  if (const Status status = this->prepareSurface(surface, partOf(progress_, 0.0, surface_share)); !status.ok())
    return status;
  return findScanRidge(*surface, settings_, partOf(progress_, surface_share, 1.0), found_);
}

template <typename PointT>
void
RidgeLines<PointT>::compute(Cloud& rail, Cloud& generator)
{
  found_ = ScanRidge();
  rail.clear();
  generator.clear();
  if (!this->computeBy("RidgeLines", [&] { return run(); }))
    found_ = ScanRidge();
  detail::toCloud(found_.rail, rail);
  detail::toCloud(found_.generator, generator);
}

} // namespace pcl_spiral
