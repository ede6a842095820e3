// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What each stage adds to the report of a spiral.
 */
#pragma once

#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/impl/constant_scallop.h>
#include <pcl_spiral/spiral/impl/path_reversals.h>
#include <pcl_spiral/spiral/impl/published_spiral.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_report.h>

namespace pcl_spiral {

/** Points, spacing, noise and warnings of the surface. \p made: true if it was made for this path, false if it was given. */
void reportSurface(const Surface& surface, bool made, SpiralReport& report);

/** Effect of the noise of the scan on the scallop height. */
void reportNoise(const Surface& surface, const SpiralSettings& settings, SpiralReport& report);

/** Loops and bridged gaps, and noise. */
void reportLoops(const BridgedSurface& bridged, const SpiralSettings& settings, SpiralReport& report);

/** Lines, with warnings for those that did not converge. */
void reportLines(const RadialLineSet& lines, const SpiralSettings& settings, TurnPlan& plan, Diagnostics& warnings);

/** Figures of a path at constant scallop height, with a warning if it leaves more than requested. */
void reportScallop(const ScallopReport& figures, const SpiralSettings& settings, TurnPlan& plan, Diagnostics& warnings);

void reportTurns(const SpiralTurns& turns, TurnPlan& plan, Diagnostics& warnings);

/** Path points over gaps, with a warning if there are any. */
void reportGaps(const GapReport& gaps, SpiralReport& report);

void reportPath(const GapReport& gaps, const AxisReport& axes, const ToolpathReport& path, SpiralReport& report);

/** Closest turns as measured, or as planned if the path has too few turns. Efficiency, with a warning if it is low. */
void reportSpacing(const ToolpathReport& path, SpiralReport& report);

/** Why the radial method made no path that can be cut: it failed (\p status), or its path of \p turns turns back on itself. Empty: it
 *  did, or it failed for a reason that the other method does not mend. */
Diagnostic whyNotRadial(const Status& status, const SpiralTurns& turns);

/** The failure of both methods in one: each may name the other as its remedy, which was tried. */
Status neitherMethod(const Status& scallop, const Status& radial);

/** Figures of the published method on \p surface, as far as it got. If the path is complete, its arrays move to \p path, with
 *  marks of gaps. */
void reportPublished(const Surface& surface, const SpiralSettings& settings, PublishedResult& published, SpiralReport& report,
                     SpiralPath& path);

} // namespace pcl_spiral
