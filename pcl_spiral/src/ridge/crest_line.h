// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The crest of a surface along a rough line.
 */
#pragma once

#include "scan_sections.h"

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/ridge/impl/smooth_line.h>

namespace pcl_spiral {

/** Where the larger curvature of \p sections is largest, a place a section: along the way of the largest sum of curvatures that
 *  moves by no more than a step from section to section, so that noise of one does not leave the crest. Of rings it ends where it begins.
 *  Feet by the scan's rim, whose fits see one side alone, take no part. */
Polyline crestOf(const Surface& surface, const ScanSections& sections, bool closed);

/** Degrees by which a section bends within \p steps to either side: the angle of its normals about \p tangent, positive where it is
 *  convex. */
double bendOf(const ScanSections& sections, std::size_t section, int steps, const Eigen::Vector3d& tangent);

} // namespace pcl_spiral
