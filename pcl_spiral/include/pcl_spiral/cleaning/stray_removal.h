// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Removes the points of a scan that lie off its surface.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/common/status.h>

#include <pcl/filters/filter_indices.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Results of a removal: points, lengths in mm. */
struct StrayFigures {
  std::size_t strays = 0;                                        ///< outliers left out; finite ones
  std::size_t nonfinite = 0;                                     ///< left out as well
  std::size_t kept_strays = 0;                                   ///< outliers kept: off the surface, but in a group larger than the limit
  std::size_t largest_group = 0;                                 ///< of outliers, including those kept, linked by steps of three spacings
  Eigen::Vector3d largest_group_place = Eigen::Vector3d::Zero(); ///< its middle
};

/** Leaves out outliers: false echoes, isolated points, clusters apart from the surface. Points that are not finite are left
 *  out too. Points of the surface stay, however close together they are.
 *
 *  For stages that use every point, such as CutterLocation, which lifts the cutter over each. An outlier may be a real object,
 *  a screw or a clamp: check what was left out (getRemovedIndices) before cutting.
 *  \code
 *  StrayRemoval<pcl::PointXYZ> removal(true); // keeps what it removed
 *  removal.setInputCloud(scan);
 *  removal.filter(*cloud);
 *  if (!removal.getStatus().ok()) ...         // and the output is empty, or all not-a-number where it is organized
 *  \endcode
 *  setNegative inverts the selection; setKeepOrganized is that of pcl::FilterIndices. The selection does not depend on the
 *  order of the points or on the number of threads.
 *  \sa buildCleanGraph, which defines the outliers */
template <typename PointT>
class StrayRemoval : public pcl::FilterIndices<PointT>, public ThreadCount {
public:
  using Ptr = pcl::shared_ptr<StrayRemoval>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const StrayRemoval>; ///< A shared pointer to a constant one.

  /** \p extract_removed_indices: if true, getRemovedIndices has the points left out. */
  explicit StrayRemoval(bool extract_removed_indices = false) : pcl::FilterIndices<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "StrayRemoval";
  }

  /** Connected outliers in groups of more points than this stay: a false echo is a single point, a screw or a clamp is not.
   *  0, the default: all are left out. */
  void setLargestGroup(std::size_t points) { largest_group_ = points; }
  std::size_t getLargestGroup() const { return largest_group_; } ///< The value of setLargestGroup.

  /** Clears the last result. A null pointer is an error at once. */
  void setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    status_ = cloud ? Status() : missingCloud();
    figures_ = StrayFigures();
    this->removed_indices_->clear();
    pcl::FilterIndices<PointT>::setInputCloud(cloud);
  }

  /** As in pcl::Filter, but the output is also empty if there is no cloud. Through a pointer to pcl::Filter, pcl::Filter::filter
   *  leaves the output unchanged in that case and does not call this filter. */
  void filter(pcl::PointCloud<PointT>& output)
  {
    if (hasCloud())
      pcl::FilterIndices<PointT>::filter(output);
    else
      output.clear();
  }
  /** \copydoc filter */
  void filter(pcl::Indices& indices)
  {
    if (hasCloud())
      pcl::FilterIndices<PointT>::filter(indices);
    else
      indices.clear();
  }

  /** Status of the last call of filter: the fault of the points if they form no surface. */
  const Status& getStatus() const { return status_; }
  const StrayFigures& getFigures() const { return figures_; } ///< Figures of the last call of filter.

protected:
  void applyFilter(pcl::Indices& indices) override; ///< What pcl::FilterIndices calls.

private:
  static Status missingCloud() { return {StatusCode::InvalidInput, "the input cloud is missing: call setInputCloud with points"}; }
  bool hasCloud();
  Status choose(pcl::Indices& kept, pcl::Indices& removed);
  std::vector<std::array<float, 3>> placesToLeaveOut(const std::vector<Eigen::Vector3f>& strays, double reach);

  std::size_t largest_group_ = 0;
  Status status_;
  StrayFigures figures_;
};

} // namespace pcl_spiral

#include <pcl_spiral/cleaning/impl/stray_removal.hpp>

namespace pcl_spiral {
extern template class StrayRemoval<pcl::PointXYZ>;
extern template class StrayRemoval<pcl::PointXYZRGB>;
extern template class StrayRemoval<pcl::PointXYZI>;
extern template class StrayRemoval<pcl::PointNormal>;
} // namespace pcl_spiral
