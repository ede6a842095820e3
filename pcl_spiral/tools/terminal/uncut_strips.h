// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Narrow strips of a part beside keep-outs that are left uncut, where no path can be planned with them.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/surface/surface.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <cstddef>
#include <vector>

/** Which strips are left uncut. */
struct StripChoice {
  double width = 0.0;                               ///< point spacings: narrower ones; 0: none
  std::vector<std::size_t> cut;                     ///< but not those with these numbers
  pcl_spiral::Surface::ConstPtr* surface = nullptr; ///< where the surface with the strips is kept from try to try; null: it is not kept
};

/** One strip. */
struct UncutStrip {
  Eigen::Vector3d place; ///< of its point in the middle
  double width = 0.0;    ///< that it is narrower than, mm
  double area = 0.0;     ///< mm2
  pcl::Indices indices;  ///< of its points in the cloud, ascending
  std::vector<Eigen::Vector3f> points;
};

/** The strips of \p cloud between what is not \p kept, ascending, and the rim of \p surface that are narrower than \p width point
 *  spacings, in the order of their first points. Points that are not on the surface are where their nearest point on it is. */
std::vector<UncutStrip> stripsBeside(const pcl_spiral::Surface& surface, const pcl::PointCloud<pcl::PointXYZ>& cloud,
                                     const pcl::Indices& kept, double width);

/** Place, width and area of a strip, and the remedy, as a warning. */
pcl_spiral::Diagnostic stripText(const UncutStrip& strip);
