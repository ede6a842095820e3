// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Point types of pcl_spiral.
 */
#pragma once

#include <pcl/impl/point_types.hpp>
#include <pcl/memory.h>
#include <pcl/pcl_macros.h>
#include <pcl/register_point_struct.h>

#include <cstdint>

namespace pcl_spiral {

/** One point of a toolpath.
 *  x y z is the cutter contact (mm), normal the unit surface normal out of the material. axis is the unit tool axis
 *  from the tip to the shank. arc_length is the length cut up to here (mm; lifts do not count), turn the number of spiral turns.
 *  arc_length is a double: in single precision, a path of kilometres loses a millimetre. over_gap is 1 where the scan has a
 *  bridged gap: there the surface is guessed from the surface around it.
 */
struct EIGEN_ALIGN16 ToolpathPoint {
  PCL_ADD_POINT4D;
  PCL_ADD_NORMAL4D;
  union {
    float data_axis[4];
    float axis[3];
    struct {
      float axis_x;
      float axis_y;
      float axis_z;
    };
  };
  double arc_length = 0.0;
  float turn = 0.0f;
  std::uint8_t over_gap = 0;

  ToolpathPoint()
  {
    x = y = z = 0.0f;
    data[3] = 1.0f;
    normal_x = normal_y = normal_z = data_n[3] = 0.0f;
    axis_x = axis_y = axis_z = data_axis[3] = 0.0f;
  }

  Eigen::Map<const Eigen::Vector3f> getAxisVector3fMap() const { return Eigen::Map<const Eigen::Vector3f>(axis); }
  Eigen::Map<Eigen::Vector3f> getAxisVector3fMap() { return Eigen::Map<Eigen::Vector3f>(axis); }

  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

} // namespace pcl_spiral

POINT_CLOUD_REGISTER_POINT_STRUCT(pcl_spiral::ToolpathPoint,
                                  (float, x, x)(float, y, y)(float, z, z)(float, normal_x, normal_x)(float, normal_y, normal_y)(
                                      float, normal_z, normal_z)(float, axis_x, axis_x)(float, axis_y, axis_y)(float, axis_z, axis_z)(
                                      double, arc_length, arc_length)(float, turn, turn)(std::uint8_t, over_gap, over_gap))
