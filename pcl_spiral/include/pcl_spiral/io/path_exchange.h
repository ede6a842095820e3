// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Paths for other programs: APT, robot frames, and plain lists of tool poses (one line per pose, a blank line between rows).
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/tool_frames.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** The seven measures of a cutter in APT: d, r, e, f, alpha, beta, h; mm and degrees. */
struct AptCutter {
  double diameter = 0.0;        ///< d
  double corner_radius = 0.0;   ///< r
  double corner_distance = 0.0; ///< e, from the axis to the centre of the corner
  double corner_height = 0.0;   ///< f, from the tip up to the centre of the corner
  double tip_angle = 0.0;       ///< alpha, between the end and a plane
  double flank_angle = 0.0;     ///< beta, between the flank and the axis
  double height = 0.0;          ///< h, of the cutter
};

/** A ball cutter four times as long as its radius. */
AptCutter ballCutter(double radius);
/** A cutter of any shape; its diameter is where the flank would meet the plane through the tip. */
AptCutter aptCutter(const CutterProfile& cutter);

/** Contents of a CLDATA file apart from its locations. */
struct AptHeader {
  std::string title;                                                ///< PARTNO
  AptCutter cutter;                                                 ///< CUTTER
  double spindle_speed = 0.0;                                       ///< rev/min; 0: no SPINDL
  SpindleDirection spindle_direction = SpindleDirection::Clockwise; ///< CLW or CCLW
  Coolant coolant = Coolant::None;                                  ///< COOLNT/MIST, FLOOD or THRU
  int tool = 0;                                                     ///< LOADTL; 0: none
};

/** Writes APT / CLDATA: PARTNO, UNITS/MM, MULTAX/ON, CUTTER/d,r,e,f,alpha,beta,h, LOADTL, SPINDL, COOLNT, FEDRAT, RAPID before each
 *  rapid, GOTO/x,y,z,i,j,k of tip and unit axis, FINI. A FEDRAT is written wherever the speed of the tip changes by a hundredth, so that
 *  the moves keep their times. \p passes: of ledPasses, or the moves of a program (movesOf). \throw FileError, also for a pass without
 *  moves */
void writeAPT(const std::string& file, const std::vector<ToolMoves>& passes, const AptHeader& header);

/** Writes robot frames in the nested lists that noether reads: a fragment, its path, a segment for each pass, its waypoints {x, y, z, qw,
 *  qx, qy, qz, speed, move}, in metres and m/s. The frames are those of toolFrames(). speed is that of the place
 *  on the way to the waypoint, and is left out of rapids; move is rapid, lead or cut. noether ignores both.
 *  \throw FileError, also for a pass without moves */
void writeRobotFrames(const std::string& file, const std::vector<ToolMoves>& passes, RobotZ z = RobotZ::Axis);

/** Writes a .6d file: x y z ax ay az on every line, tip in mm and unit tool axis in the workpiece frame. It is the
 *  list that the feature-line method for ridges in 3-D laser surface hardening writes (China Mechanical Engineering).
 *  \throw FileError the file cannot be written, there are no poses, a row has fewer than two poses,
 *  a pose is not finite, or its axis is not a unit vector */
void writePoseVectors(const std::string& file, const std::vector<ToolPoses>& passes);

/** Writes a .5d file: x y z A C on every line, tip in mm, angles in degrees for the machine xyzacTrunnion(). C continues
 *  over 360. Of the two ways to reach an axis, (A, C) and (-A, C + 180), each line has the one nearer to the line before.
 *  So C turns by at most 90 degrees from line to line; for an upright axis C stays. Between lines a control moves both
 *  angles evenly: near upright, use closely spaced lines. Same source. \throw FileError as writePoseVectors */
void writePoseAngles(const std::string& file, const std::vector<ToolPoses>& passes);

} // namespace pcl_spiral
