// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places and polygons of a scan that are chosen in a view of it.
 */
#pragma once

#include "visualization/part_view.h"

#include <pcl_spiral/visualization/spiral_viewer.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** The message for a choice. */
std::string partInWords(const PartSelection& part);

/** Turns a place of the scan in memory into the coordinates of its file. */
using FileCoordinates = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/** The point of \p cloud at \p pixel: of those within 4 pixels the one nearest to the viewer, otherwise the nearest within 12; nothing if
 *  there is none. */
std::optional<Eigen::Vector3d> pickScanPoint(const PartView& view, const pcl::PointCloud<pcl::PointXYZ>& cloud,
                                             const Eigen::Vector2d& pixel);

/** X,Y,Z with as many digits as the place has in its file. */
std::string placeInFile(const Eigen::Vector3d& place, const FileCoordinates& in_file);

/** Writes \p corners as a polygon file for readPolygon, in file coordinates: x y z. \throw FileError */
void writePolygon(const std::string& file, const std::vector<Eigen::Vector3d>& corners, const FileCoordinates& in_file);

} // namespace pcl_spiral
