// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Smooths the tool axes of passes along them.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/status.h>

#include <optional>

namespace pcl_spiral {

/** How axes are smoothed. Lengths in mm, angles in degrees. */
struct PassAxisSettings {
  double smoothing_length = 0.0;   ///< shorter changes along a pass are smoothed away; 0: none are
  double max_rate = 0.0;           ///< largest turn of the axis per mm; 0: no limit
  double max_deviation = 20.0;     ///< from the axes asked for, that smoothing may cause in the mean over its length
  double largest_deviation = 45.0; ///< at any point; farther off, passes no longer cover the surface
  std::optional<double> stand_off; ///< of a beam from the surface, along the normal: each point moves so that the spot of the beam stays
};

/** What smoothing cost. */
struct PassAxisReport {
  double largest_deviation = 0.0; ///< from the axes asked for, degrees
  Diagnostics warnings;
};

/** Distance of the spot of a beam from drive point \p p along the axis: the point is \p stand_off above the surface, along the normal. */
double beamReach(const DrivePoint& p, double stand_off);

/** Smooths the axes of each pass along it and limits their turn, see smoothAxes in core/smooth_axes.h. A closed pass has no ends: it is
 *  smoothed as if the tool went round it again and again. Without a smoothing length and a rate, passes stay as they are.
 *  InvalidArgument: a setting out of range, or an axis too far from the one asked for; passes are then unchanged. */
Status smoothPassAxes(const PassAxisSettings& settings, DrivePasses& passes, PassAxisReport& report);

} // namespace pcl_spiral
