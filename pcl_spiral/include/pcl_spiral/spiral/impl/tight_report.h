// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the ball leaves where it does not reach the surface, for the report.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/surface/impl/ball_reach.h>
#include <pcl_spiral/surface/surface.h>

#include <memory>

namespace pcl_spiral {

/** Ok, or an error if \p surface has clusters to ride over, but \p settings do not lift the ball. */
Status checkRidden(const Surface& surface, const SpiralSettings& settings);

/** Reach of the ball of \p settings on \p surface, which continues in the patches \p beyond; null with TightHandling::Refuse. */
std::unique_ptr<BallReach> makeReach(const Surface& surface, const SpiralSettings& settings, const std::vector<SurfacePatch>& beyond = {});

/** The same into \p reach. Or an error, and null, if it misses more than half of the points: that is the wrong cutter for the part, or
 *  the wrong unit. Names the tightest place and the radius that reaches nine tenths of the points. */
Status makeReach(const Surface& surface, const SpiralSettings& settings, const std::vector<SurfacePatch>& beyond,
                 std::unique_ptr<BallReach>& reach);

/** Places of \p reach where more than the scallop height stays, lifts of \p path, and reversals of the ball there (ballReversals), with
 *  warnings. */
void reportTight(const BallReach& reach, const SpiralPath& path, const SpiralSettings& settings, SpiralReport& report);

} // namespace pcl_spiral
