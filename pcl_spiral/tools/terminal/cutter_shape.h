// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cutter of --tool-radius, --corner-radius, --flank-length and --flank-angle.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>

constexpr const char* corner_radius_help = "corner radius; default the largest possible, a ball: --corner-radius 1";
constexpr const char* flank_angle_help = "angle between flank and axis; default 0: --flank-angle 5";

/** Without a corner radius the cutter becomes a ball, or a tapered ball. \throw UsageError for an impossible cutter */
void completeCutter(bool corner_given, pcl_spiral::CutterShape& cutter);
