// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Which limits a judged path keeps, breaks, or cannot be shown to keep.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <pcl_spiral/verify/verification.h>

namespace pcl_spiral {

/** The limits that do not hold, each with the value found and its place. Any limit is broken if points were not judged, or have
 *  normals, axes or tool tips that are wrong. The faults of a program come first, with or without limits. Messages name limits as
 *  Limits::gouge. */
Diagnostics brokenLimits(const Limits& limits, const Verification& verification);

/** Normals, axes and tool tips that are wrong, with their number and place: no cutter can be judged by them, with or without limits. */
Diagnostics faultsOfPoses(const Verification& verification);

/** The limits that are kept but lie below leastShown, where noise and deviation cannot be told apart. With any limit: the points
 *  in gaps, where there is nothing to judge by. */
Diagnostics unprovenLimits(const Limits& limits, const Verification& verification);

/** The smallest value that the reference can show, mm: three standard deviations of its surface. */
double leastShown(const DeviationReport& deviation);

enum class Verdict { NoLimits, Kept, Unproven, Broken };

/** The worst that Verification::broken and Verification::unproven report. */
Verdict verdictOf(const Limits& limits, const Verification& verification);

} // namespace pcl_spiral
