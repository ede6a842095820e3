/** \file
 *  Writers of plain lists of tool poses: a line a pose, a blank line between rows.
 */
#pragma once

#include <pcl_spiral/machine/impl/tool_pose.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** A .6d: x y z ax ay az on every line, tip in mm and unit tool axis in the workpiece's frame. A list as the feature-line method for
 *  ridges in 3-D laser surface hardening puts out (China Mechanical Engineering).
 *  \throw FileError the file cannot be written, there are no poses, a row has fewer than two, or one is not finite or its axis no
 *  unit vector */
void writePoseVectors(const std::string& file, const std::vector<ToolPoses>& passes);

/** A .5d: x y z A C on every line, tip in mm and angles in degrees of the machine xyzacTrunnion(). C goes on over 360. Of the two ways to reach an axis,
 *  (A, C) and (-A, C + 180), each line has the one nearer to the line before, so that C turns by 90 degrees at most from line to line; where the axis is
 *  upright C stays. Between lines a control leads both angles evenly: near the upright give lines that lie close. Same source.
 *  \throw FileError as writePoseVectors */
void writePoseAngles(const std::string& file, const std::vector<ToolPoses>& passes);

} // namespace pcl_spiral
