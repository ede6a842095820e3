// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The place of a measured generator on its rail. Private to ridge.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/ridge_frame.h>
#include <pcl_spiral/ridge/impl/smooth_line.h>
#include <pcl_spiral/ridge/ridge_surface.h>

namespace pcl_spiral {

/** A generator in the frame of the rail. Lengths in mm, the tilt in degrees. */
struct GeneratorPlace {
  bool turns_rail = false;              ///< the rail must run the other way; then nothing else is set
  double meeting = 0.0, distance = 0.0; ///< arc length of the rail, and of both lines there
  double chord_length = 0.0, tilt = 0.0;
  RidgeChord chord;
  MeasuredLine local; ///< its points in order from start to end, in coordinates along m1, m2, m3
  Diagnostics warnings;
};

/** Put a generator in the frame of \p rail where both meet. \p may_turn: the result may be that the rail must run the other way. */
Status placeGenerator(const MeasuredLine& measured, const SmoothLine& rail, const RidgeSettings& settings, bool may_turn,
                      GeneratorPlace& place);

/** Refuses a rail that turns by more than 30 degrees at one place. \p error: of its points. */
Status checkCorners(const MeasuredLine& rail, double error);

} // namespace pcl_spiral
