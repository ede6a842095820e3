// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A drive point as a drop needs it. Private.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/cutter/impl/cutter_drop.h>
#include <pcl_spiral/cutter/tool_location.h>

#include <algorithm>

namespace pcl_spiral {

constexpr double rim_reach = 2.0;    ///< in radii: what lies lower beyond a rim would have to rise at 45 degrees
constexpr double steep_share = 0.35; ///< of the normal along the axis: 70 degrees

/** The axis of a drive point, from the tip where the cutter touches the contact, if one is asked for. */
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

  /** Whether it asks for a contact on a surface so steep that heights along the axis say little. */
  bool isSteep() const { return asks && frame.axis.dot(normal) < steep_share; }

  /** Set state and lift of \p location where the cutter touches at \p height above the tip asked for; returns the height to
   * stand at. */
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
    return contact.touches ? std::max(0.0, height) : height; // never below the contact asked for
  }
};

} // namespace pcl_spiral
