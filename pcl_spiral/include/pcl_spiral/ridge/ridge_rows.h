// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Rows of a tool over a ridge.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/ridge/ridge_surface.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Direction of the rows. */
enum class RidgeDirection {
  AlongRail, ///< each row is one place of the generator, moved along the rail
  AcrossRail ///< each row is the generator at one place of the rail
};

/** Spacing of the points of a row. */
enum class RidgeSteps {
  EqualOnRow, ///< at equal distances on each row
  Stations    ///< as published: at equal steps of the rail, or of the generator, the same for all rows
};

/** Settings of rows. Lengths in mm, angles in degrees. Set exactly one of these for
 *  the distance between rows: step-over; spot size; tool radius with scallop height. */
struct RidgeRowSettings {
  RidgeDirection direction = RidgeDirection::AlongRail; ///< of the rows
  bool zigzag = true;                                   ///< in zigzag; false: all in one direction
  double step_over = 0.0;                               ///< largest distance between neighbouring rows
  double spot_size = 0.0;                               ///< diameter of the spot of a beam
  double overlap = 0.0;                                 ///< share of the spot that the next row covers again, from 0 to below 1
  double tool_radius = 0.0;                             ///< of a ball cutter
  double scallop_height = 0.0;                          ///< that the ball may leave
  double point_spacing = 1.0;                           ///< largest distance between consecutive points on the surface
  double chord_error = 0.01; ///< of straight moves, for contact and tool; equal steps are made shorter until it holds; 0: no limit
  RidgeSteps steps = RidgeSteps::EqualOnRow; ///< spacing of the points of a row
  RidgeNormals normals = RidgeNormals::True; ///< which normals the points have
  double stand_off = 0.0;                    ///< distance of the tool from the contact, along the normal
  double lead = 0.0;                         ///< lean of the axis forward, at the contact; the tool stays on the normal
  double tilt = 0.0;                         ///< lean of the axis to the right of travel, in the same way
  double run_in = 0.0;                       ///< straight extension before each row that is not closed
  double run_out = 0.0;                      ///< the same after the row
};

/** All of them but the tool radius, which goes with the scallop height. */
std::vector<Setting> settingTable(RidgeRowSettings& settings);

/** Report of rows. Lengths in mm. */
struct RidgeRowReport {
  std::size_t rows = 0;      ///< number of rows
  std::size_t points = 0;    ///< of all rows
  double length = 0.0;       ///< of all rows
  double largest_step = 0.0; ///< between neighbouring rows
  Diagnostics warnings;      ///< in full sentences, with the remedy
};

/** Rows over \p surface. The outermost rows are half a step-over from the edges of the ridge. On a closed rail, rows along it are closed,
 *  and rows across it are spread evenly. Drive points have the surface's normal; a stand-off puts them off the surface. InvalidArgument:
 *  a setting out of range; no or several settings for the step-over. InvalidInput: a hollow tighter than the ball, with its place. */
Status planRidgeRows(const RidgeSurface& surface, const RidgeRowSettings& settings, DrivePasses& passes, RidgeRowReport& report);

} // namespace pcl_spiral
