// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far a scan is from the surface that its rail and generator sweep.
 */
#pragma once

#include "section_rounds.h"

#include <pcl_spiral/ridge/impl/ridge_lines_engine.h>

namespace pcl_spiral {

/** Misfit of the scan's points to the ridge of \p rounds; with a warning if it is well above the noise. */
void findMisfit(SectionRounds& rounds, double half_width, ScanRidgeReport& report);

} // namespace pcl_spiral
