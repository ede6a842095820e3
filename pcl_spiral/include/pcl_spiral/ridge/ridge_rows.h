/** \file
 *  Rows of a tool over a ridge.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/ridge/ridge_surface.h>
#include <pcl_spiral/common/drive_pass.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Which way rows run. */
enum class RidgeDirection {
  AlongRail, ///< each row is one place of the generator, carried along the rail
  AcrossRail ///< each row is the generator at one place of the rail
};

/** How the points of a row lie. */
enum class RidgeSteps {
  EqualOnRow, ///< equally far from one another on each row
  Stations    ///< as published: at equal steps of the rail, or of the generator, the same for all rows
};

/** What rows are asked for. Lengths in mm, angles in degrees. One of step-over, spot size, and tool radius with scallop height tells
 *  how far rows are apart. */
struct RidgeRowSettings {
  RidgeDirection direction = RidgeDirection::AlongRail;
  bool zigzag = true;           ///< to and fro; else all one way
  double step_over = 0.0;       ///< largest distance of neighbouring rows
  double spot_size = 0.0;       ///< diameter of a beam's spot
  double overlap = 0.0;         ///< share of the spot that the next row covers again, from 0 to below 1
  double tool_radius = 0.0, scallop_height = 0.0; ///< of a ball
  double point_spacing = 1.0;   ///< largest distance of consecutive points on the surface
  double chord_error = 0.01;    ///< of straight moves between equal steps, of the contact and of the tool: they are made shorter until it holds; 0: any
  RidgeSteps steps = RidgeSteps::EqualOnRow;
  RidgeNormals normals = RidgeNormals::True;
  double stand_off = 0.0;       ///< of the tool from the contact, along the normal
  double lead = 0.0, tilt = 0.0; ///< of the axis: forward, and to the right of travel of the contact; the tool stays on the normal
  double run_in = 0.0, run_out = 0.0; ///< straight on before and behind each row that does not go round
};

/** What came of rows. Lengths in mm. */
struct RidgeRowReport {
  std::size_t rows = 0, points = 0;
  double length = 0.0;        ///< of all rows
  double largest_step = 0.0;  ///< between neighbouring rows
  std::vector<std::string> warnings;
};

/** Rows over \p surface. Between the outermost rows and the edges of the ridge lies half a step-over. Round a closed rail rows along it are closed, and
 *  rows across it spread evenly. Drive points carry the surface's normal; with a stand-off their place is off the surface by it.
 *  InvalidArgument: a setting out of range, none or several that tell the step-over. InvalidInput: a hollow tighter than the ball, with its place. */
Status planRidgeRows(const RidgeSurface& surface, const RidgeRowSettings& settings, DrivePasses& passes, RidgeRowReport& report);

} // namespace pcl_spiral
