// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/search/impl/usable_points.h>
#include <pcl_spiral/surface/impl/side_text.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/console/print.h>
#include <pcl/impl/pcl_base.hpp> // for point types that PCL has not compiled

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {

template <typename PointT, typename PointNT>
Status
ScannedSurface<PointT, PointNT>::checkNormals(std::size_t size) const
{
  if (!normals_ || normals_->size() == size)
    return Status::success();
  return {StatusCode::InvalidInput, Diagnostic("there are ", normals_->size(), " normals for ", size,
                                               " points: call {setInputNormals} with one a point, or with none")};
}

template <typename PointT, typename PointNT>
Status
ScannedSurface<PointT, PointNT>::check() const
{
  if (!this->input_ || this->input_->empty())
    return {StatusCode::InvalidInput, "the input cloud is missing or empty: call {setInputCloud} with points"};
  const std::size_t size = this->input_->size();
  if (const Status status = checkNormals(size); !status.ok())
    return status;
  if (const Diagnostic fault = rangeFault(settings_); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  return checkIndices(givenIndices(), size);
}

/** The settings, with the place of the sensor in the cloud as the view point if none was set. */
template <typename PointT, typename PointNT>
SurfaceSettings
ScannedSurface<PointT, PointNT>::sidedSettings() const
{
  SurfaceSettings settings = settings_;
  const Eigen::Vector3f sensor = this->input_->sensor_origin_.template head<3>();
  if (!settings.view_point && sensor.allFinite() && !sensor.isZero(0.0f))
    settings.view_point = sensor.cast<double>();
  return settings;
}

/** Run the statistical filter and thinning, and record what they drop. */
template <typename PointT, typename PointNT>
Status
ScannedSurface<PointT, PointNT>::filter(UsablePoints& usable, SurfaceReport& counts, std::vector<std::uint32_t>& dropped,
                                        std::vector<LeftOut>& why) const
{
  const auto keep = [&](const std::vector<std::uint32_t>& kept, LeftOut reason) {
    std::size_t next = 0;
    for (std::uint32_t i = 0; i < usable.source.size(); ++i)
      if (next < kept.size() && kept[next] == i)
        ++next;
      else {
        dropped.push_back(usable.source[i]);
        why.push_back(reason);
      }
    return usable.keep(kept);
  };
  if (settings_.outlier_neighbours > 0)
    counts.outlier =
        keep(statisticalInliers(usable.positions, settings_.outlier_neighbours, settings_.outlier_deviations), LeftOut::Outlier);
  if (settings_.thinning > 0.0) {
    const std::vector<std::uint32_t> kept = voxelRepresentatives(usable.positions, settings_.thinning);
    if (kept.empty() && !usable.source.empty())
      return {StatusCode::InvalidArgument, Diagnostic("the thinning edge ", settings_.thinning,
                                                      " {mm} is too small for the size of the {cloud}: raise it, or check the units")};
    counts.thinned = keep(kept, LeftOut::Thinned);
  }
  return Status::success();
}

template <typename PointT, typename PointNT>
void
ScannedSurface<PointT, PointNT>::addLeftOut(const std::vector<std::uint32_t>& indices, const std::vector<LeftOut>& why,
                                            LeftOutPoints& points) const
{
  std::vector<std::size_t> order(indices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return indices[a] < indices[b]; });
  for (const std::size_t i : order) {
    points.positions.push_back((*this->input_)[indices[i]].getVector3fMap());
    points.indices.push_back(static_cast<pcl::index_t>(indices[i]));
    points.why.push_back(why[i]);
  }
}

template <typename PointT, typename PointNT>
Status
ScannedSurface<PointT, PointNT>::run(Surface::ConstPtr& surface)
{
  const ThreadLimit limit(settings_.threads);
  if (const Status status = check(); !status.ok())
    return status;
  const auto going = [&](double share) { return !progress_ || progress_(share, "surface"); };
  const Status cancelled(StatusCode::Cancelled, "cancelled");
  if (!going(0.0))
    return cancelled;
  UsablePoints usable = usablePoints(*this->input_, givenIndices());
  SurfaceReport counts;
  counts.input = usable.asked_for;
  counts.nonfinite = usable.nonfinite;
  counts.duplicate = usable.duplicates;
  if (usable.source.empty())
    return {StatusCode::InvalidInput,
            Diagnostic("none of the ", counts.input, " points is finite: check the {scan}, or the columns of its file")};
  std::vector<std::uint32_t> dropped; // indices in the cloud
  std::vector<LeftOut> reasons;
  if (const Status status = filter(usable, counts, dropped, reasons); !status.ok())
    return status;
  if (!going(0.1))
    return cancelled;
  SurfacePoints points;
  if (normals_)
    points.normals = normalsOf(*normals_, usable.source);
  points.positions = std::move(usable.positions);
  const bool all = usable.source.size() == this->input_->size() && !givenIndices();
  if (all)
    std::vector<std::uint32_t>().swap(usable.source);
  points.source = usable.source;
  Surface::Parts parts;
  std::vector<std::int8_t> why;
  const bool no_normal =
      normals_ && std::all_of(points.normals.begin(), points.normals.end(), [](const auto& n) { return n.isZero(0.0f); });
  if (no_normal && settings_.strict && settings_.trust_normals)
    return {StatusCode::InvalidInput,
            Diagnostic("none of the ", points.normals.size(),
                       " input normals has a direction, they are all zero or not numbers: give normals out of the "
                       "material, or none ({setInputNormals} with a null pointer)")};
  if (const Status status = makeSurface(std::move(points), sidedSettings(), counts, parts, why); !status.ok())
    return status;
  if (!settings_.view_point)
    for (Diagnostic& warning : sensorWarnings(parts.side))
      parts.warnings.push_back(std::move(warning));
  if (no_normal)
    parts.warnings.push_back("the input normals are all zero or not numbers, and were not used");
  for (std::uint32_t i = 0; i < why.size(); ++i)
    if (why[i] >= 0) {
      dropped.push_back(all ? i : usable.source[i]);
      reasons.push_back(static_cast<LeftOut>(why[i]));
    }
  addLeftOut(dropped, reasons, parts.left_out);
  for (StandingCluster& cluster : parts.clusters)
    for (pcl::index_t& i : cluster.indices)
      i = all ? i : static_cast<pcl::index_t>(usable.source[static_cast<std::size_t>(i)]);
  parts.input_size = this->input_->size();
  const auto made = std::make_shared<Surface>(std::move(parts));
  if (const Status status = settings_.strict ? checkSingleSheet(*made) : Status::success(); !status.ok())
    return status;
  if (const Status status = checkSide(*made); !status.ok())
    return status;
  if (!going(1.0))
    return cancelled;
  surface = made;
  return Status::success();
}

/** When strict: the input normals give a side only if nine in ten agree on it. */
template <typename PointT, typename PointNT>
Status
ScannedSurface<PointT, PointNT>::checkSide(const Surface& surface) const
{
  if (!normals_ || !settings_.strict || !settings_.trust_normals)
    return Status::success();
  std::size_t same = 0, other = 0;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const float dot = surface.graph().normals()[i].dot((*normals_)[surface.sourceIndex(i)].getNormalVector3fMap());
    same += dot > 0.0f;
    other += dot < 0.0f;
  }
  if (9 * std::min(same, other) <= std::max(same, other))
    return Status::success();
  return {StatusCode::InvalidInput, Diagnostic("the input normals have no common side: ", same, " point to one, ", other,
                                               " to the other: orient them, or give none ({setInputNormals})")};
}

template <typename PointT, typename PointNT>
void
ScannedSurface<PointT, PointNT>::compute(Surface::ConstPtr& surface)
{
  surface.reset();
  status_ = Status::unfinished();
  status_ = run(surface);
  if (!quiet_ && !status_.ok() && status_.code() != StatusCode::Cancelled)
    PCL_ERROR("[pcl_spiral::ScannedSurface::compute] %s\n", status_.message().c_str());
}

} // namespace pcl_spiral
