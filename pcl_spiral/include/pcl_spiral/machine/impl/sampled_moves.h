// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places of the tool on the way between the blocks of a program.
 */
#pragma once

#include <pcl_spiral/machine/impl/kinematics.h>
#include <pcl_spiral/machine/impl/tool_pose.h>
#include <pcl_spiral/machine/machine_program.h>

namespace pcl_spiral {

/** How the moves of a program are sampled. */
struct MoveSampling {
  double arm = 0.0;        ///< from the tip along the axis to the point whose way counts: the radius of a ball, mm
  double tolerance = 1e-3; ///< of that point from the straight line between samples, mm
  bool axis_arcs = false;  ///< the axis moves along an arc; false: as the rotary axes turn it
  bool tip_too = false;    ///< the tip keeps the tolerance, too
};

/** The pose at the end of \p block. */
ToolPose poseOf(const ProgramBlock& block);

/** The pose at share \p t of the move from \p from to \p to as the control makes it: with RTCP the tip moves on a straight line, without it
 *  the linear axes move evenly; the rotary axes turn evenly. \p axis_arcs: see MoveSampling. */
ToolPose poseOnMove(const Kinematics& kinematics, const ProgramBlock& from, const ProgramBlock& to, double t, bool axis_arcs);

/** Poses on the move from \p from to \p to as the control makes it, without the first and with the last. With RTCP the tip moves on a
 *  straight line, without it the linear axes move evenly; the rotary axes turn evenly, by at most 0.1 radians from pose to pose. The point
 *  at the arm then moves on an arc so flat that its middle and quarters show how far it bows. */
ToolPoses sampledMove(const Kinematics& kinematics, const ProgramBlock& from, const ProgramBlock& to, const MoveSampling& sampling);

} // namespace pcl_spiral
