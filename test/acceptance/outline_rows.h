// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The outlines for judging paths, their limits and their clouds. Lengths in mm.
 */
#pragma once

#include "cases.h"

#include "support/surfaces.h"

#include <string>
#include <vector>

namespace pcl_spiral::acceptance {

/** Arrangement of the points of an outline. */
enum class Scan { Even, Noisy, Lines, Sparse, Gap };

/** An outline, its scan, and the limits of a path over it. Heights in h, radii in pitches. */
struct OutlineRow {
  std::string name, outline; ///< of the row, and for outlinedPart
  double length = 0.0;       ///< length over the least length
  Scan scan = Scan::Even;
  double noise = 0.0; ///< standard deviation
  double p999 = 1.02;
  double over = 0.0005; ///< share above 1.05
  double max = 1.25;
  double radius = 0.2; ///< a thousandth of the path may have a smaller radius
  double time = 0.10;  ///< machine time over the least, beyond the ratio of lengths
};

std::vector<OutlineRow> outlineRows();

/** The part of a row and its points. */
struct OutlineCloud {
  test::SurfacePtr part;
  std::vector<Eigen::Vector3d> points;
  double spacing = 0.0; ///< of the same number of points spread evenly; for scan lines the distance of the lines
  test::PlaneLoop gap;  ///< gap of the scan; may be empty
};

/** The cloud for a cutter whose exact step-over on the plane is \p pitch. */
OutlineCloud outlineCloud(const OutlineRow& row, const Options& options, double pitch);

} // namespace pcl_spiral::acceptance
