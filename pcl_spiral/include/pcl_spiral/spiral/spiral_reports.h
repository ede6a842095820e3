/** \file
 *  What each stage adds to the report of a spiral.
 */
#pragma once

#include <pcl_spiral/spiral/impl/constant_scallop.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/impl/published_spiral.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_turns.h>
#include <pcl_spiral/spiral/spiral_report.h>

namespace pcl_spiral {

/** Allowed error of a turn between radial lines, mm: a fiftieth of the step-over on a plane. */
double
lineTolerance(const SpiralSettings& settings);

/** Allowed distance of a radial line's B-spline from its points, mm. */
double
lineFitTolerance(const SpiralSettings& settings);

/** Points, spacing, noise and warnings of the surface; \p made: for this path, rather than given. */
void
reportSurface(const Surface& surface, bool made, SpiralReport& report);

/** What the scan's noise means for the scallop height. */
void
reportNoise(const Surface& surface, const SpiralSettings& settings, SpiralReport& report);

/** Loops and bridged gaps, and noise. */
void
reportLoops(const BridgedSurface& bridged, const SpiralSettings& settings, SpiralReport& report);

/** Lines, with warnings of what did not settle. */
void
reportLines(const RadialLineSet& lines, const SpiralSettings& settings, SpiralReport& report);

/** What a path at constant scallop height came to, with a warning where it leaves more than asked for. */
void
reportScallop(const ScallopFigures& figures, const SpiralSettings& settings, SpiralReport& report);

void
reportTurns(const SpiralTurns& turns, SpiralReport& report);

/** Path points over gaps, with a warning where there are some. */
void
reportGaps(const GapFigures& gaps, SpiralReport& report);

void
reportPath(const GapFigures& gaps, const AxisFigures& axes, const PathFigures& path, SpiralReport& report);

/** What the published chain came to on \p surface, as far as it got; the arrays of a whole path become those of \p path, with
 *  marks of gaps. */
void
reportPublished(const Surface& surface, const SpiralSettings& settings, PublishedResult& published, SpiralReport& report,
                SpiralPath& path);

} // namespace pcl_spiral
