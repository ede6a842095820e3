// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The crest of a surface along a rough line.
 */
#pragma once

#include "scan_sections.h"

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/ridge/impl/smooth_line.h>

namespace pcl_spiral {

/** The places where the larger curvature of \p sections is largest, one a section: the way with the largest sum of curvatures that
 *  moves by at most one step from section to section, so noise of one section does not leave the crest. On rings it ends where it
 *  begins. Feet near the rim of the scan, whose fits have points on one side only, are not used. */
Polyline crestOf(const Surface& surface, const ScanSections& sections, bool closed);

/** Degrees by which a section bends within \p steps to either side: the angle of its normals about \p tangent, positive where it is
 *  convex. */
double bendOf(const ScanSections& sections, std::size_t section, int steps, const Eigen::Vector3d& tangent);

} // namespace pcl_spiral
