// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Removes the points of a scan that lie off its surface.
 */
#pragma once

#include <pcl_spiral/cleaning/impl/status_filter.h>
#include <pcl_spiral/common/impl/thread_limit.h>

#include <pcl/point_types.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Results of a removal: points, lengths in mm. */
struct OutlierReport {
  std::size_t outliers = 0;                                      ///< outliers left out; finite ones
  std::size_t nonfinite = 0;                                     ///< left out as well
  std::size_t kept_outliers = 0;                                 ///< outliers kept: off the surface, but in a group larger than the limit
  std::size_t largest_group = 0;                                 ///< of outliers, including those kept, linked by steps of three spacings
  Eigen::Vector3d largest_group_place = Eigen::Vector3d::Zero(); ///< its middle
};

/** \deprecated Use OutlierReport. */
using OutlierFigures [[deprecated("use OutlierReport")]] = OutlierReport;

/** Leaves out outliers: false echoes, isolated points, clusters apart from the surface. Points that are not finite are left
 *  out too. Points of the surface stay, however close together they are.
 *
 *  For stages that use every point, such as CutterLocation, which lifts the cutter over each. An outlier may be a real object,
 *  a screw or a clamp: check what was left out (getRemovedIndices) before cutting.
 *  \code
 *  OutlierRemoval<pcl::PointXYZ> removal(true); // keeps what it removed
 *  removal.setInputCloud(scan);
 *  removal.filter(*cloud);
 *  if (!removal.getStatus().ok()) ...         // and the output is empty, or all not-a-number where it is organized
 *  \endcode
 *  setNegative inverts the selection; setKeepOrganized is that of pcl::FilterIndices. The selection does not depend on the
 *  order of the points or on the number of threads.
 *  \sa buildCleanGraph, which defines the outliers */
template <typename PointT>
class OutlierRemoval : public StatusFilter<PointT>, public ThreadCount {
public:
  using Ptr = pcl::shared_ptr<OutlierRemoval>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const OutlierRemoval>; ///< A shared pointer to a constant one.

  /** \p extract_removed_indices: if true, getRemovedIndices has the points left out. */
  explicit OutlierRemoval(bool extract_removed_indices = false) : StatusFilter<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "OutlierRemoval";
  }

  /** Connected outliers in groups of more points than this stay: a false echo is a single point, a screw or a clamp is not.
   *  0, the default: all are left out. */
  void setLargestGroup(std::size_t points) { largest_group_ = points; }
  std::size_t getLargestGroup() const { return largest_group_; } ///< The value of setLargestGroup.

  const OutlierReport& getReport() const { return figures_; }                                     ///< Figures of the last call of filter.
  [[deprecated("use getReport")]] const OutlierReport& getFigures() const { return getReport(); } ///< \deprecated Use getReport.

protected:
  void forgetResult() override { figures_ = OutlierReport(); } ///< Clears the figures.
  /** Fails if the points form no surface. */
  Status choose(pcl::Indices& kept, pcl::Indices& removed) override;

private:
  std::vector<std::array<float, 3>> placesToLeaveOut(const std::vector<Eigen::Vector3f>& outliers, double reach);

  std::size_t largest_group_ = 0;
  OutlierReport figures_;
};

/** \deprecated Renamed OutlierReport, its fields strays and kept_strays outliers and kept_outliers. */
using StrayFigures [[deprecated("use OutlierReport")]] = OutlierReport;

/** \deprecated Renamed OutlierRemoval. */
template <typename PointT>
using StrayRemoval [[deprecated("use OutlierRemoval")]] = OutlierRemoval<PointT>;

} // namespace pcl_spiral

#include <pcl_spiral/cleaning/impl/outlier_removal.hpp>

namespace pcl_spiral {
extern template class OutlierRemoval<pcl::PointXYZ>;
extern template class OutlierRemoval<pcl::PointXYZRGB>;
extern template class OutlierRemoval<pcl::PointXYZI>;
extern template class OutlierRemoval<pcl::PointNormal>;
} // namespace pcl_spiral
