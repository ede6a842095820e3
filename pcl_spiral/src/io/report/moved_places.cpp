// SPDX-License-Identifier: BSD-3-Clause
#include "moved_places.h"

#include <optional>
#include <utility>

namespace pcl_spiral {

SpiralSettings
movedBy(const Eigen::Vector3d& shift, SpiralSettings settings)
{
  for (std::optional<Eigen::Vector3d>* place : {&settings.centre, &settings.start_point, &settings.view_point, &settings.part_at})
    if (*place)
      **place += shift;
  return settings;
}

SpiralReport
movedBy(const Eigen::Vector3d& shift, SpiralReport report)
{
  if (shift.isZero())
    return report;
  for (Eigen::Vector3d* place : {&report.centre, &report.sharpest_place, &report.closest_place})
    if (!place->isZero()) // zero: none
      *place += shift;
  for (HoleReport& hole : report.holes)
    hole.place += shift;
  for (TightPlace& tight : report.tight_places)
    tight.place += shift;
  for (BoundaryLoop& loop : report.loops)
    for (Eigen::Vector3d& place : loop.curve)
      place += shift;
  return report;
}

Verification
movedBy(const Eigen::Vector3d& shift, Verification v)
{
  DeviationReport& d = v.deviation;
  RemovalReport& r = v.removal;
  if (shift.isZero())
    return v;
  for (PlacedValue* value : {&d.max, &d.rim_max, &d.gap_max, &d.crease_max, &d.normal_error, &d.first_opposed, &d.first_inward,
                             &d.wobble.max, &d.motion.gap, &d.motion.turn, &d.motion.axis_change, &d.motion.normal_change, &d.lift_max,
                             &r.gouge, &r.rim_gouge, &r.crease_gouge, &r.face_depth, &r.face_gouge, &v.tip_error})
    value->position += shift;
  for (StockReport* figures : {&r.stock, &r.scallop, &r.rim, &r.unreached, &r.crease})
    for (PlacedValue* value : {&figures->max, &figures->first_uncut})
      value->position += shift;
  return v;
}

Vocabulary
movedBy(const Eigen::Vector3d& shift, Vocabulary words)
{
  if (!words.place && !shift.isZero())
    words.place = [shift](const Eigen::Vector3d& place) { return placeText(place + shift); };
  return words;
}

RunReport
movedBy(const Eigen::Vector3d& shift, RunReport report)
{
  report.settings = movedBy(shift, std::move(report.settings));
  const auto move = [&shift](PathReport& path) {
    path.report = movedBy(shift, std::move(path.report));
    if (path.verification)
      path.verification = movedBy(shift, std::move(*path.verification));
  };
  move(report);
  for (PathReport& region : report.regions)
    move(region);
  return report;
}

} // namespace pcl_spiral
