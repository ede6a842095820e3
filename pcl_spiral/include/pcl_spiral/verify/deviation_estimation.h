// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distance of the points of a toolpath from a scan.
 */
#pragma once

#include <pcl_spiral/verify/figures.h>
#include <pcl_spiral/verify/impl/deviation_estimation_engine.h>
#include <pcl_spiral/verify/impl/reference_input.h>

namespace pcl_spiral {

/** Signed distance of each point of a toolpath from a scanned surface,
 *  the angle of its normal, and how the path moves.
 *
 *  setInputCloud takes the reference: the raw scan, that of the planner or another one. The distance
 *  is to a local fit of the raw points; see ReferenceSurface for the part of it that is noise.
 *  Positive out of the material. Lengths in mm, angles in degrees. The input is never changed. */
template <typename PointT>
class DeviationEstimation : public ReferenceInput<PointT> {
public:
  using Ptr = pcl::shared_ptr<DeviationEstimation>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const DeviationEstimation>; ///< A shared pointer to a constant one.

  /** Measures. \p output has one point per path point, in their order: its place, with the
   *  deviation as intensity, NaN where there is no surface. It is empty on failure: a missing
   *  or unfit reference or toolpath, no path point on the reference, or cancelled. */
  void compute(pcl::PointCloud<pcl::PointXYZI>& output);

  const DeviationReport& getReport() const { return figures_; }                                     ///< Figures of the last compute.
  [[deprecated("use getReport")]] const DeviationReport& getFigures() const { return getReport(); } ///< \deprecated Use getReport.

private:
  DeviationReport figures_;
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/deviation_estimation.hpp>

namespace pcl_spiral {
extern template class ReferenceInput<pcl::PointXYZ>;
extern template class ReferenceInput<pcl::PointXYZRGB>;
extern template class ReferenceInput<pcl::PointNormal>;
extern template class DeviationEstimation<pcl::PointXYZ>;
extern template class DeviationEstimation<pcl::PointXYZRGB>;
extern template class DeviationEstimation<pcl::PointNormal>;
} // namespace pcl_spiral
