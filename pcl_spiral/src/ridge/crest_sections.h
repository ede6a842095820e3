// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The crest along rough points, and the sections of the scan across it.
 */
#pragma once

#include "scan_sections.h"

#include <pcl_spiral/ridge/impl/ridge_lines_engine.h>
#include <pcl_spiral/ridge/impl/smooth_line.h>

namespace pcl_spiral {

/** A smooth crest, and sections across places of it. */
struct CrestSections {
  SmoothLine line;
  Polyline places, tangents; ///< of the sections
  ScanSections sections;
};

/** The crest near the rough points. InvalidInput with the place: rough points off the scan, no crest, a band that leaves the scan. */
Status findCrest(const Surface& surface, const ScanRidgeSettings& settings, CrestSections& crest);

/** Steps that nine sections in ten reach on \p side before the scan ends; \p worst: the section that reaches least far. */
int commonReach(const ScanSections& sections, int side, std::size_t& worst);

} // namespace pcl_spiral
