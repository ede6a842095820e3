// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The time of a program in words.
 */
#pragma once

#include <pcl_spiral/machine/motion_time.h>

#include <string>

namespace pcl_spiral {

/** What a change is called in JSON: feed, acceleration, tolerance, rotary_blend, chord_error, axis_smoothing, longer_blocks. */
const char* nameOf(MotionChange change);

/** What the change does, such as "feed 1.5 times as high". */
const char* wordsOf(MotionChange change);

/** Where the time of \p study goes, in shares of it: "47 % at the feed, 0 % corners, 53 % rotary axes, ...". */
std::string lossesText(const MotionStudy& study);

/** "12.3 s", "4.5 min", "3 h 20 min" */
std::string durationText(double seconds);

/** The time of \p study, the control, and where it goes: "4.5 min on LinuxCNC: 47 % at the feed, ...". */
std::string motionText(const MotionStudy& study);

/** The change that gains most and its share of the time; if none gains a hundredth, that. */
std::string gainText(const MotionStudy& study);

} // namespace pcl_spiral
