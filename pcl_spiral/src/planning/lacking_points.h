// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places where a scan has too few points. Private to planning.
 */
#pragma once

#include <pcl_spiral/planning/impl/spiral_planning.h>

namespace pcl_spiral {

/** Where the scan of \p input has fewer points than elsewhere, if the refusal \p said asks for another scan and its first place is such a
 *  place; else nothing: then it is not the scan that keeps the path from being made. */
Diagnostic lackOf(const PlanInput& input, const Diagnostic& said);

} // namespace pcl_spiral
