// SPDX-License-Identifier: BSD-3-Clause
#include "pass_defaults.h"

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

bool
isBallEnd(const CutterShape& cutter)
{
  return cutter.radius > 0.0 && cutter.flank_angle == 0.0 && cutter.corner_radius == cutter.radius;
}

void
setLargestCorner(CutterShape& cutter)
{
  const double angle = cutter.flank_angle * degree;
  cutter.corner_radius = angle == 0.0 ? cutter.radius : (cutter.radius - cutter.flank_length * std::sin(angle)) / std::cos(angle);
}

void
completeDrive(const AskedSettings& asked, const PassSettings& tool, bool on_mesh, DriveSettings& drive)
{
  drive.cutter = tool.cutter;
  if (!asked.chord_error)
    drive.chord_error = 0.5 * tool.tolerance;
  if (on_mesh && !asked.point_spacing)
    drive.point_spacing = tool.cutter.radius;
  if (!(drive.scallop_height > 0.0))
    return;
  const bool can_keep =
      drive.kind == DriveKind::Planes && drive.axisMode() != DriveAxisMode::Cylinder && (isBallEnd(tool.cutter) || !on_mesh);
  if (can_keep && !asked.rows)
    drive.rows = DriveRows::Kept;
  if (faultOf(tool.cutter).empty())
    drive.step_over = stepForScallop(CutterProfile(tool.cutter), drive.scallop_height).value_or(drive.step_over);
}

void
completeRidge(const AskedSettings& asked, PassSettings& tool, RidgeRowSettings& rows)
{
  const bool is_beam = !(tool.cutter.radius > 0.0);
  if (!is_beam && rows.scallop_height > 0.0) {
    rows.tool_radius = tool.cutter.radius;
    if (!asked.tolerance)
      tool.tolerance = std::min(tool.tolerance, 0.5 * rows.scallop_height);
  }
  if (!asked.chord_error)
    rows.chord_error = is_beam ? tool.tolerance : 0.5 * tool.tolerance;
}

} // namespace pcl_spiral
