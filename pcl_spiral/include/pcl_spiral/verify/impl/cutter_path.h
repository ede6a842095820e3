// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A toolpath prepared for measuring, and places on it.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/verify/figures.h>

#include <pcl/point_cloud.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A toolpath in double precision: parallel arrays. Lengths in mm. */
struct CutterPath {
  Polyline contacts;
  std::vector<Eigen::Vector3d> normals; ///< unit, out of the material
  std::vector<Eigen::Vector3d> axes;    ///< unit, from the tip to the shank; empty if the path has none
  std::vector<float> turns;             ///< turns completed up to each point
  std::vector<float> lifts;             ///< ToolpathPoint::lift of each point
  std::vector<std::size_t> passes;      ///< where the second pass and each further one begin: the move there is a lift and does not cut
  std::size_t size() const { return contacts.size(); }
};

/** Takes \p value and its place if it is above \p largest. */
inline void
raise(PlacedValue& largest, double value, const Eigen::Vector3d& position, std::size_t index)
{
  if (value > largest.value)
    largest = {value, position, index};
}

/** Reads a toolpath. Fails if there is none, on fewer than two points, a point that is not finite, and a normal of length
 *  zero. An axis of length zero at any point leaves the path without axes. \p passes: where the second pass and each
 *  further one begin; empty: found from the arc lengths, see passBegins. Fails if they do not ascend within the path. */
Status readCutterPath(const pcl::PointCloud<ToolpathPoint>::ConstPtr& toolpath, CutterPath& path,
                      const std::vector<std::size_t>& passes = {});

/** Length of all passes, mm. */
double cutLength(const CutterPath& path);

/** Lengths, lifts and largest changes of direction of \p path. */
PathMotion pathMotion(const CutterPath& path);

} // namespace pcl_spiral
