// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Step-over on a plane from the true profile of a cutter.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

#include <optional>

namespace pcl_spiral {

/** Largest distance, mm, between two parallel passes on a plane, with the axis along its normal, that leaves no ridge
 * between them higher than \p scallop, mm: twice the largest distance from the axis at which the profile
 * is not higher than that.
 *
 *  The ridge midway between passes s apart is z(s / 2) high. For a ball that gives 2 sqrt(R^2 - (R - h)^2),
 * for a bull-nose 2 R2 + 2 sqrt(r^2 - (r - h)^2), for a flat end 2 R: its edges meet and leave no ridge. Never
 * more than 2 R. Empty if \p scallop is not above 0. */
std::optional<double> stepForScallop(const CutterProfile& profile, double scallop);

} // namespace pcl_spiral
