// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From radial lines to the turns of a spiral, as one curve.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/radial_lines_engine.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>
#include <pcl_spiral/spiral/impl/turn_function.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** The curve, before it is put on the surface, and its figures. Lengths in mm. */
struct SpiralTurns {
  std::vector<SpiralPoint> curve;
  double smallest_step_over = 0.0, largest_step_over = 0.0; ///< on the surface along the lines
  double largest_allowed_step = 0.0;                        ///< longest linear move
  CornerRidge corner_ridge;
  std::vector<std::string> warnings;
};

/** Turns between \p lines at the step-over that \p settings define (TurnFunction), drawn as one curve (SpiralCurve).
 *  \p spacing and \p area, mm2, of the surface. Fails where the cutter does not fit, where a line leaves the surface, or if the
 *  path is too large. */
Status makeTurns(const RadialLineSet& lines, double spacing, double area, const SpiralSettings& settings, SpiralTurns& turns);

/** Ok, or an error in the user's own \p lines, for a surface of this \p spacing: too few lines, wrong order, feet that are not
 *  finite or have left the surface, levels out of range or none 0, no rim, an inner boundary of one or two points. The message
 *  reports which line, and where. */
Status checkLines(const RadialLineSet& lines, double spacing);

} // namespace pcl_spiral
