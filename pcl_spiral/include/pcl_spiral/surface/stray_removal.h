/** \file
 *  A scan without the points that lie off its surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>

#include <pcl/filters/filter_indices.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Leaves out strays: false echoes, points that stand alone, specks apart from the surface. Points that are not finite go
 *  too. Points of the surface stay, however close they stand.
 *
 *  For stages that hold to every point, such as CutterLocation, which lifts the cutter over each. A stray may be a thing
 *  that stands there, a screw or a clamp: look at what is left out (getRemovedIndices) before cutting.
 *  \code
 *  StrayRemoval<pcl::PointXYZ> removal(true); // keeps what it removed
 *  removal.setInputCloud(scan);
 *  removal.filter(*cloud);
 *  if (!removal.getStatus().ok()) ...         // and the output is empty
 *  \endcode
 *  setNegative turns the choice round, setKeepOrganized is that of pcl::FilterIndices. The choice does not depend on the
 *  order of the points nor on the number of threads.
 *  \sa buildCleanGraph, which says what is sought */
template <typename PointT>
class StrayRemoval : public pcl::FilterIndices<PointT> {
public:
  using Ptr = pcl::shared_ptr<StrayRemoval>;
  using ConstPtr = pcl::shared_ptr<const StrayRemoval>;

  explicit StrayRemoval(bool extract_removed_indices = false) : pcl::FilterIndices<PointT>(extract_removed_indices)
  {
    this->filter_name_ = "StrayRemoval";
  }

  /** Of the last call of filter: what is wrong with the points where they form no surface. */
  const Status&
  getStatus() const
  {
    return status_;
  }

protected:
  void applyFilter(pcl::Indices& indices) override;

private:
  Status choose(pcl::Indices& kept, pcl::Indices& removed) const;

  Status status_;
};

} // namespace pcl_spiral

#include <pcl_spiral/surface/impl/stray_removal.hpp>

namespace pcl_spiral {
extern template class StrayRemoval<pcl::PointXYZ>;
extern template class StrayRemoval<pcl::PointXYZRGB>;
extern template class StrayRemoval<pcl::PointXYZI>;
extern template class StrayRemoval<pcl::PointNormal>;
} // namespace pcl_spiral
