// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings of passes that follow from others unless they are asked for: the same for all faces of the library.
 */
#pragma once

#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/ridge/ridge_rows.h>

namespace pcl_spiral {

/** Which settings were asked for. */
struct AskedSettings {
  bool rows = false;
  bool point_spacing = false;
  bool tolerance = false;
  bool chord_error = false;
};

/** Whether \p cutter ends in a ball on a cylinder. */
bool isBallEnd(const CutterShape& cutter);

/** Gives \p cutter the largest corner that its other measures leave room for: a ball, or a ball that continues its cone. */
void setLargestCorner(CutterShape& cutter);

/** The cutter follows the passes. A scallop height makes the step-over, and rows that keep it where they can be kept. The chord error is
 *  half of the tolerance: the other half is for the moves between locations. On a mesh the chord error adds points, so the point spacing
 *  is the cutter's radius. */
void completeDrive(const AskedSettings& asked, const PassSettings& tool, bool on_mesh, DriveSettings& drive);

/** The same of rows over a ridge; their scallop height is that of the cutter, which must be a ball, and the tolerance is at most half of
 *  it. A beam has no locations: its chord error is the tolerance. */
void completeRidge(const AskedSettings& asked, PassSettings& tool, RidgeRowSettings& rows);

} // namespace pcl_spiral
