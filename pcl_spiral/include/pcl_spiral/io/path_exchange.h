/** \file
 *  Paths for other programs, apart from any machine: APT and robot frames.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include <pcl/point_cloud.h>

#include <string>

namespace pcl_spiral {

/** APT's seven measures of a cutter: d, r, e, f, alpha, beta, h; mm and degrees. */
struct AptCutter {
  double diameter = 0.0;
  double corner_radius = 0.0;
  double corner_distance = 0.0; ///< e, of the corner's centre from the axis
  double corner_height = 0.0;   ///< f, of the corner's centre above the tip
  double tip_angle = 0.0;       ///< alpha, of the end against a plane
  double flank_angle = 0.0;     ///< beta, of the flank against the axis
  double height = 0.0;
};

/** A ball cutter as long as four times its radius. */
AptCutter ballCutter(double radius);
/** A cutter of any shape; its diameter is where the flank would meet the plane through the tip. */
AptCutter aptCutter(const CutterProfile& cutter);

/** What a CLDATA file says beyond its locations. */
struct AptHeader {
  std::string title; ///< PARTNO
  AptCutter cutter;
  double spindle_speed = 0.0; ///< rev/min; 0: no SPINDL
  double feed = 0.0;          ///< at the contact, mm/min
};

/** APT / CLDATA: PARTNO, UNITS/MM, MULTAX/ON, CUTTER/d,r,e,f,alpha,beta,h, SPINDL, FEDRAT, GOTO/x,y,z,i,j,k
 * of tip and unit axis, FINI. A FEDRAT stands wherever the tip's speed changes by a hundredth for the contact
 * to keep the feed. Poses are one pass: of a path with lifts give each of ballPasses a file of its own. \throw FileError */
void writeAPT(const std::string& file, const ToolPoses& poses, const AptHeader& header);

/** Robot frames as noether nests them: fragments of paths of segments of waypoints {x, y, z, qw, qx, qy, qz},
 * metres; one of each. z is the outward normal, x the direction of travel in the surface. \throw FileError,
 * also for a path without points or of several passes */
void writeRobotFrames(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path);

} // namespace pcl_spiral
