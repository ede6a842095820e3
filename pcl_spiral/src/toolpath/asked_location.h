/** \file
 *  A drive point as a drop needs it. Private to toolpath.
 */
#pragma once

#include <pcl_spiral/toolpath/cutter_drop.h>
#include <pcl_spiral/toolpath/drive_point.h>

namespace pcl_spiral {

/** The axis of a drive point, from the tip where the cutter touches the contact, if one is asked for. */
struct AskedLocation {
  AskedLocation(const DrivePoint& drive, const CutterProfile& profile)
      : asks(drive.asksForContact()), position(drive.position),
        normal(asks ? drive.normal.normalized() : drive.normal),
        contact(asks ? profile.locate(drive.position, drive.normal.normalized(), drive.axis.normalized())
                     : CutterContact()),
        frame(asks ? contact.tip : drive.position, drive.axis.normalized())
  {
  }
  bool asks;
  Eigen::Vector3d position, normal;
  CutterContact contact;
  AxisFrame frame;
};

} // namespace pcl_spiral
