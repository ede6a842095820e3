/** \file
 *  From radial lines to the turns of a spiral, as one curve.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/radial_line_builder.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/spiral/impl/turn_function.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** The curve, before it is put on the surface, and what it came to. Lengths in mm. */
struct SpiralTurns {
  std::vector<SpiralPoint> curve;
  double smallest_step_over = 0.0, largest_step_over = 0.0; ///< of the surface along the lines
  double largest_allowed_step = 0.0;                        ///< longest linear move
  CornerRidge corner_ridge;
  std::vector<std::string> warnings;
};

/** Turns between \p lines at the step-over that \p settings ask for (TurnFunction), drawn as one curve (SpiralCurve).
 *  \p spacing and \p area, mm2, of the surface. Fails where the cutter does not fit, where a line leaves the surface, and on a
 *  path too large to be made. */
Status
makeTurns(const RadialLineSet& lines, double spacing, double area, const SpiralSettings& settings, SpiralTurns& turns);

/** Ok, or what is wrong with \p lines from elsewhere, for a surface of this \p spacing: none or few, not in order, feet that
 *  are not finite or left the surface, levels out of range or none 0, no rim, an inner boundary of one or two points. Says
 *  which line, and where. */
Status
checkLines(const RadialLineSet& lines, double spacing);

} // namespace pcl_spiral
