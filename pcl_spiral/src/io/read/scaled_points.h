// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points of a file in mm.
 */
#pragma once

#include "point_table.h"

#include <pcl_spiral/io/cloud_reader.h>

namespace pcl_spiral {

/** The columns x y z as points: scaled and shifted in double precision, then rounded to float. */
pcl::PointCloud<pcl::PointXYZ>::Ptr scaledPoints(const PointTable& table, const ReadOptions& options);

/** Warnings if rounding to float changes points by more than 0.001 mm, or if the size suggests another unit. */
std::vector<std::string> scaleWarnings(const std::string& file, const pcl::PointCloud<pcl::PointXYZ>& cloud);

} // namespace pcl_spiral
