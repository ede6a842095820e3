// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Leans axes away from what they hit, smoothly along a pass. Private.
 */
#pragma once

#include "axis_disc.h"
#include "location_ground.h"

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Whether the axis of a location should be turned: it is lifted off the contact asked for, or the holder collides. */
bool isWanting(const ToolLocation& location);

/** Turns the axes of one pass where that helps, so that from one location to the next the turn changes by at most a given angle.
 *
 *  About every place that wants it, as far to both sides as the turn needs to begin and to end, all turns of a disc are tried at the
 *  contact that was asked for or touched; where there is no normal, about the tip, and only once they are chosen. Among the ways
 *  through the turns that are free, the one with the least sum of squared turns is taken (dynamic programming; the ways go by stations
 *  as far apart as the next turn of the disc needs, with even changes between them). Then all is located as usual; turns that are not
 *  free after all, because of what is between the stations or of the fitted surface, are barred, and the way is sought again. Places
 *  where no turn is free stay as they are, or follow their neighbours. */
class SmoothRetilt {
public:
  /** \p holder must be free where turns are tried. \p most: largest turn; \p step: largest change of it; both in radians. */
  SmoothRetilt(const LocationGround& ground, const HolderProfile& holder, double most, double step);

  /** \p drive and \p locations: of one pass. */
  void run(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const;

private:
  struct Place;
  using Places = std::vector<Place>;

  Place placeOf(const DrivePoint& drive, const ToolLocation& location, const Place* before) const;
  void piece(const DrivePoint* drive, std::size_t count, ToolLocation* locations) const;
  void window(Place* places, std::size_t count, bool from_zero, bool to_zero, ToolLocation* locations) const;
  void tryTurns(Place& place) const;
  double costAt(const Place* places, const std::vector<std::size_t>& stations, std::size_t s, std::size_t turn) const;
  std::vector<Eigen::Vector2d> bestWay(const Place* places, const std::vector<std::size_t>& stations, bool from_zero, bool to_zero) const;
  std::size_t bar(Place* places, std::size_t count, const std::vector<Eigen::Vector2d>& turns, const ToolLocations& found) const;

  const LocationGround& ground_;
  HolderProfile holder_;
  AxisDisc disc_;
  double step_;
  std::size_t stride_, ramp_; ///< places between stations; places that a largest turn needs to begin
};

} // namespace pcl_spiral
