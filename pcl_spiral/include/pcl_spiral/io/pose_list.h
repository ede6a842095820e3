// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Writers of plain lists of tool poses: one line per pose, a blank line between rows.
 */
#pragma once

#include <pcl_spiral/machine/impl/tool_pose.h>

#include <string>
#include <vector>

namespace pcl_spiral {

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
