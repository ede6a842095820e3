// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points of a file in mm.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "number_column.h"
#include "point_table.h"

#include <pcl_spiral/io/cloud_reader.h>

namespace pcl_spiral {

/** Points in mm, rounded to float. */
struct ScaledPoints {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud; ///< never null
  Eigen::Vector3d shift;                     ///< see Scan::shift
  /** If rounding to float changes points by more than 0.001 mm, or if the size suggests another unit. */
  Diagnostics warnings;
};

/** The columns x y z of \p file as points: scaled and shifted in double precision, then rounded to float. */
ScaledPoints scaledPoints(const std::string& file, const PointColumns& columns, const ReadOptions& options);
/** The same of the first three columns of \p table. */
ScaledPoints scaledPoints(const std::string& file, const PointTable& table, const ReadOptions& options);

/** Normals of unit length; zero where one is not finite. Null if all are zero. */
pcl::PointCloud<pcl::Normal>::Ptr unitNormals(const PointColumns& columns);

} // namespace pcl_spiral
