// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A drive point, prepared for a drop. Private.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/cutter/impl/cutter_drop.h>
#include <pcl_spiral/cutter/tool_location.h>

#include <algorithm>

namespace pcl_spiral {

constexpr double rim_reach = 2.0;    ///< in radii: lower material beyond a rim would have to rise at 45 degrees to touch the cutter
constexpr double steep_share = 0.35; ///< of the normal along the axis: 70 degrees

/** The axis of a drive point. It starts at the tip that touches the contact, if a contact is given. */
struct AskedLocation {
  AskedLocation(const DrivePoint& drive, const CutterProfile& profile)
  : asks(drive.asksForContact()), position(drive.position), normal(asks ? drive.normal.normalized() : drive.normal),
    contact(asks ? profile.locate(drive.position, drive.normal.normalized(), drive.axis.normalized()) : CutterContact()),
    frame(asks ? contact.tip : drive.position, drive.axis.normalized())
  {}
  bool asks;
  Eigen::Vector3d position, normal;
  CutterContact contact;
  AxisFrame frame;

  /** Whether the given contact is on a surface too steep for heights along the axis. */
  bool isSteep() const { return asks && frame.axis.dot(normal) < steep_share; }

  /** Whether the given contact is steep, and the cutter of \p inner, smaller by \p near all round, meets nothing there deeper
   *  than that. */
  template <typename Drop>
  bool holds(const Drop& inner, double near) const
  {
    return isSteep() && contact.touches && !inner.highest(frame, near).found;
  }

  /** Set how high \p location stands above the rim, by a drop on it; the cutter is at \p height. */
  template <typename Drop>
  void findRim(const Drop& rim_drop, double radius, double height, ToolLocation& location) const
  {
    const auto rim = rim_drop.highest(frame, height - rim_reach * radius);
    location.over_rim = rim.found;
    location.rim_clearance = rim.found ? std::max(0.0, height - rim.height) : 0.0;
  }

  /** Set state and lift of \p location for a cutter that touches at \p height above the given tip; returns the height of
   *  the cutter. */
  double settle(double height, double tolerance, ToolLocation& location) const
  {
    location.state = LocationState::Touching;
    if (!asks)
      return height;
    location.lift = height;
    if (!contact.touches)
      location.state = LocationState::Unreachable;
    else if (height > tolerance)
      location.state = LocationState::Lifted;
    else if (height < -tolerance)
      location.state = LocationState::Clear;
    else
      location.state = LocationState::Reached;
    return contact.touches ? std::max(0.0, height) : height; // never below the given contact
  }

  /** Set contact and normal of a settled \p location at \p height, so that they are those of the cutter at its tip: at the contact asked
   *  for, where the cutter is there, else next to where the surface was met. */
  void settleContact(const CutterProfile& profile, double height, ToolLocation& location) const
  {
    if (location.state == LocationState::Reached || location.state == LocationState::Clear) {
      location.contact = position + height * location.axis;
      location.normal = normal;
      return;
    }
    const CutterTouch touch = profile.touchAt(location.tip, location.axis, location.contact, location.normal);
    location.contact = touch.place;
    location.normal = touch.normal;
  }
};

} // namespace pcl_spiral
