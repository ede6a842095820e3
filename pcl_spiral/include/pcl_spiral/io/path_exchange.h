// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Paths for other programs, independent of any machine: APT and robot frames.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include <pcl/point_cloud.h>

#include <string>

namespace pcl_spiral {

/** The seven measures of a cutter in APT: d, r, e, f, alpha, beta, h; mm and degrees. */
struct AptCutter {
  double diameter = 0.0;
  double corner_radius = 0.0;
  double corner_distance = 0.0; ///< e, from the axis to the centre of the corner
  double corner_height = 0.0;   ///< f, from the tip up to the centre of the corner
  double tip_angle = 0.0;       ///< alpha, between the end and a plane
  double flank_angle = 0.0;     ///< beta, between the flank and the axis
  double height = 0.0;
};

/** A ball cutter four times as long as its radius. */
AptCutter ballCutter(double radius);
/** A cutter of any shape; its diameter is where the flank would meet the plane through the tip. */
AptCutter aptCutter(const CutterProfile& cutter);

/** Contents of a CLDATA file apart from its locations. */
struct AptHeader {
  std::string title; ///< PARTNO
  AptCutter cutter;
  double spindle_speed = 0.0; ///< rev/min; 0: no SPINDL
  double feed = 0.0;          ///< at the contact, mm/min
};

/** Writes APT / CLDATA: PARTNO, UNITS/MM, MULTAX/ON, CUTTER/d,r,e,f,alpha,beta,h, SPINDL, FEDRAT, GOTO/x,y,z,i,j,k of tip
 *  and unit axis, FINI. A FEDRAT is written wherever the speed of the tip changes by a hundredth, so that the contact keeps
 *  the feed. Poses are one pass: for a path with lifts, write each of ballPasses to its own file. \throw FileError */
void writeAPT(const std::string& file, const ToolPoses& poses, const AptHeader& header);

/** Writes robot frames nested as in noether: fragments of paths of segments of waypoints {x, y,
 *  z, qw, qx, qy, qz}, in metres; one of each. z is the outward normal, x the direction of travel
 *  in the surface. \throw FileError, also for a path without points or with several passes */
void writeRobotFrames(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path);

} // namespace pcl_spiral
