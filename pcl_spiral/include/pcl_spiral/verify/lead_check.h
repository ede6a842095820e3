// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks whether a tool comes to its path and leaves it without cutting into the scan.
 */
#pragma once

#include <pcl_spiral/verify/impl/lead_check_engine.h>
#include <pcl_spiral/verify/impl/tool_check.h>

#include <pcl/point_types.h>

namespace pcl_spiral {

/** Checks what a program does apart from cutting: approaches, leads, retracts, all moves between passes, turns at the top. A rapid
 *  counts, whatever its section. To check the path itself, use HolderCheck for shank and holder, CutterLocation, or
 *  DeviationEstimation and MaterialRemoval.
 *
 *  setInputCloud takes the scan, in the workpiece frame of the program. Every point counts,
 *  also outliers, so add whatever else stands on the table. With setLargestEcho the check
 *  also tells false echoes from the part and from clamps. Above the cutter, a shank as wide as
 *  the cutter is assumed, without an end. Lengths in mm. The result does not depend on the order
 *  of the points or on the number of threads.
 *  \code
 *  LeadCheck<pcl::PointXYZ> check;
 *  check.setInputCloud(scan);
 *  check.setCutter(CutterShape::ball(5.0));
 *  check.compute(program);
 *  if (!check.getStatus().ok()) ...            // could not be looked at
 *  if (check.getReport().collided > 0) ...    // check.getReport().deepest says where
 *  \endcode */
template <typename PointT>
class LeadCheck : public ToolCheck<PointT> {
public:
  using Ptr = pcl::shared_ptr<LeadCheck>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const LeadCheck>; ///< A shared pointer to a constant one.

  /** Checks \p program. Fails without a cloud or a cutter, on invalid settings, or when cancelled. */
  void compute(const MachineProgram& program);
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/lead_check.hpp>

namespace pcl_spiral {
extern template class LeadCheck<pcl::PointXYZ>;
extern template class LeadCheck<pcl::PointXYZRGB>;
extern template class LeadCheck<pcl::PointNormal>;
} // namespace pcl_spiral
