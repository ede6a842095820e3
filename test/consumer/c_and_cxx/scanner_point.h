// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A point as some scanner gives it: unknown to PCL and to pcl_spiral.
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

struct EIGEN_ALIGN16 ScannerPoint {
  PCL_ADD_POINT4D;
  float confidence;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT(ScannerPoint, (float, x, x)(float, y, y)(float, z, z)(float, confidence, confidence))

using ScannerCloud = pcl::PointCloud<ScannerPoint>;

/** Whether the stages from the cloud to the tool axes are right on a dome of \p radius about the origin, \p rim wide. */
bool stagesAreRight(const ScannerCloud::Ptr& dome, double radius, double rim);
