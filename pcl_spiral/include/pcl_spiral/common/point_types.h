// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The point type of toolpaths, and where their passes begin.
 */
#pragma once

#include <pcl/impl/point_types.hpp>
#include <pcl/memory.h>
#include <pcl/pcl_macros.h>
#include <pcl/point_cloud.h>
#include <pcl/register_point_struct.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** One point of a toolpath.
 *  x y z is the cutter contact (mm), normal the unit surface normal out of the material. axis is the unit tool axis
 *  from the tip to the shank. arc_length is the length cut up to here (mm; lifts do not count), turn the number of spiral turns.
 *  arc_length is a double: in single precision, a path of kilometres loses a millimetre. over_gap is 1 where the scan has a
 *  bridged gap: there the surface is guessed from the surface around it. lift is the distance of x y z from the surface where the ball
 *  is too large to touch it: contact + radius normal is always the centre of the ball.
 */
struct EIGEN_ALIGN16 ToolpathPoint {
  ///@{
  /** The cutter contact, mm. */
  PCL_ADD_POINT4D;
  ///@}
  ///@{
  /** Normal of the surface, unit, out of the material. */
  PCL_ADD_NORMAL4D;
  ///@}
  union {
    float data_axis[4];
    float axis[3];
    struct {
      float axis_x;
      float axis_y;
      float axis_z;
    };
  };
  double arc_length = 0.0;   ///< mm, cut up to here; lifts do not count
  float turn = 0.0f;         ///< turns completed up to here; for rows, the number of the row
  std::uint8_t over_gap = 0; ///< 1 over a bridged gap of the scan
  float lift = 0.0f;         ///< mm, off the surface where the ball does not reach it; 0 elsewhere

  ToolpathPoint()
  {
    x = y = z = 0.0f;
    data[3] = 1.0f;
    normal_x = normal_y = normal_z = data_n[3] = 0.0f;
    axis_x = axis_y = axis_z = data_axis[3] = 0.0f;
  }

  Eigen::Map<const Eigen::Vector3f> getAxisVector3fMap() const { return Eigen::Map<const Eigen::Vector3f>(axis); } ///< The tool axis.
  Eigen::Map<Eigen::Vector3f> getAxisVector3fMap() { return Eigen::Map<Eigen::Vector3f>(axis); } ///< The tool axis, to be set.

  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace pcl_spiral

POINT_CLOUD_REGISTER_POINT_STRUCT(pcl_spiral::ToolpathPoint,
                                  (float, x, x)(float, y, y)(float, z, z)(float, normal_x, normal_x)(float, normal_y, normal_y)(
                                      float, normal_z, normal_z)(float, axis_x, axis_x)(float, axis_y, axis_y)(float, axis_z, axis_z)(
                                      double, arc_length, arc_length)(float, turn, turn)(std::uint8_t, over_gap, over_gap)(float, lift,
                                                                                                                           lift))

namespace pcl_spiral {

/** True if the tool is lifted on a move of \p distance mm over which the arc length grows by \p grown mm: lifts add no arc length. */
inline bool
isLift(double distance, double grown)
{
  constexpr double least = 0.01;  // mm: shorter moves are not lifts
  constexpr double share = 0.001; // of the move: files round arc lengths
  return distance > least && grown < share * distance;
}

/** Points of \p path at which the second and each later pass begins: the arc length does not grow on the move there, in any file
 *  format. Empty for one pass, and for a path without arc lengths. */
inline std::vector<std::size_t>
passBegins(const pcl::PointCloud<ToolpathPoint>& path)
{
  std::vector<std::size_t> begins;
  if (path.empty() || !(path.back().arc_length > path.front().arc_length))
    return begins;
  for (std::size_t i = 1; i < path.size(); ++i)
    if (isLift((path[i].getVector3fMap() - path[i - 1].getVector3fMap()).norm(), path[i].arc_length - path[i - 1].arc_length))
      begins.push_back(i);
  return begins;
}

} // namespace pcl_spiral
