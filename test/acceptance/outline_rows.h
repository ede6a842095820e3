// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The outlines that paths are judged on, their limits and their clouds. Lengths in mm.
 */
#pragma once

#include "cases.h"

#include "support/surfaces.h"

#include <string>
#include <vector>

namespace pcl_spiral::acceptance {

/** How the points of an outline lie. */
enum class Scan { Even, Noisy, Lines, Sparse, Gap };

/** An outline, its scan, and what a path over it must hold. Heights in h, radii in pitches. */
struct OutlineRow {
  std::string name, outline; ///< of the row, and as outlinedPart knows it
  double length = 0.0;       ///< over the least
  Scan scan = Scan::Even;
  double noise = 0.0; ///< standard deviation
  double p999 = 1.02;
  double over = 0.0005; ///< share above 1.05
  double max = 1.25;
  double radius = 0.2; ///< that a thousandth of the path may be sharper than
  double time = 0.10;  ///< machine time over the least beyond the length's ratio
};

std::vector<OutlineRow> outlineRows();

/** A row's part and its points. */
struct OutlineCloud {
  test::SurfacePtr part;
  std::vector<Eigen::Vector3d> points;
  double spacing = 0.0; ///< of as many points spread evenly; between lines that of the lines
  test::PlaneLoop gap;  ///< where the scan has none; may be empty
};

/** The cloud for a cutter whose exact step-over on the plane is \p pitch. */
OutlineCloud outlineCloud(const OutlineRow& row, const Options& options, double pitch);

} // namespace pcl_spiral::acceptance
