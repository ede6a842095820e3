// SPDX-License-Identifier: BSD-3-Clause
// Helix, rings and arcs about the axis of a column.
#include "drive_kinds.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** Number of equal steps of an arc on the column's mean radius that climbs by \p climb. */
std::size_t
stepsOf(const DriveColumn& column, double angle, double climb, double spacing)
{
  const double length = std::hypot(column.radius * angle, climb);
  return static_cast<std::size_t>(std::max(3.0, std::ceil(length / spacing - 1e-9)));
}

void
add(const DriveColumn& column, double angle, double along, DrivePass& pass)
{
  DrivePoint point;
  point.position = placeAbout(column.cylinder, column.radius, angle, along);
  pass.points.push_back(point);
}

/** One turn on the level of the first ring, one turn for each step between rings, and one turn on the level of
 *  the last ring. */
DrivePass
helix(const DriveColumn& column, const EqualSteps& rings, double spacing)
{
  const std::size_t a_turn = stepsOf(column, 2.0 * pi, rings.step, spacing), levels = rings.middles.size(),
                    turns = levels > 1 ? levels + 1 : 1;
  DrivePass pass;
  for (std::size_t i = 0; i <= turns * a_turn; ++i) {
    const double turn = static_cast<double>(i) / static_cast<double>(a_turn);
    const double climbed = std::clamp(turn - 1.0, 0.0, static_cast<double>(levels - 1));
    add(column, 2.0 * pi * static_cast<double>(i % a_turn) / static_cast<double>(a_turn), rings.middles.front() + rings.step * climbed,
        pass);
  }
  return pass;
}

DrivePass
ring(const DriveColumn& column, double along, double spacing)
{
  const std::size_t steps = stepsOf(column, 2.0 * pi, 0.0, spacing);
  DrivePass pass;
  pass.closed = true;
  for (std::size_t i = 0; i < steps; ++i)
    add(column, 2.0 * pi * static_cast<double>(i) / static_cast<double>(steps), along, pass);
  return pass;
}

DrivePass
arc(const DriveColumn& column, double along, double spacing)
{
  const double first = column.first_angle * pi / 180.0, covered = column.covered_angle * pi / 180.0;
  const std::size_t steps = stepsOf(column, covered, 0.0, spacing);
  DrivePass pass;
  for (std::size_t i = 0; i <= steps; ++i)
    add(column, first + covered * static_cast<double>(i) / static_cast<double>(steps), along, pass);
  return pass;
}

} // namespace

Status
planRings(const DriveSettings& settings, DrivePasses& passes, DriveReport& report)
{
  const DriveColumn& column = *report.column;
  const bool sector = column.covered_angle < 360.0;
  if (sector && settings.kind == DriveKind::Helix)
    return {StatusCode::InvalidInput,
            Diagnostic("the part covers only ", column.covered_angle, " {degrees} about the axis of the column, from ", column.first_angle,
                       " on: a helix would leave the part in every turn; choose rings, which become arcs")};
  const double first = column.cylinder.first - settings.overrun, last = column.cylinder.last + settings.overrun;
  const double height = last - first, around = 2.0 * pi * column.radius;
  const double lines = height / settings.step_over + 2.0;
  if (const Status status = checkDriveSize(lines * (around / settings.point_spacing + 3.0), 0.0, settings); !status.ok())
    return status;
  const EqualSteps rings = equalSteps(first, last, settings.step_over);
  report.step_over = rings.step;
  if (settings.kind == DriveKind::Helix) {
    passes.push_back(helix(column, rings, settings.point_spacing));
    return Status::success();
  }
  for (std::size_t k = 0; k < rings.middles.size(); ++k) {
    passes.push_back(sector ? arc(column, rings.middles[k], settings.point_spacing)
                            : ring(column, rings.middles[k], settings.point_spacing));
    if (sector && settings.zigzag && k % 2 == 1)
      std::reverse(passes.back().points.begin(), passes.back().points.end());
  }
  return Status::success();
}

} // namespace pcl_spiral
