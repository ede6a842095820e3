// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reader of machine files.
 */
#pragma once

#include <pcl_spiral/machine/machine.h>

#include <string>

namespace pcl_spiral {

/** Reads a machine from YAML; mm, degrees, rev/min, mm/min. Unknown names are refused.
 *
 *  \code
 *  name: xyzac-trt            # optional
 *  rotary:                    # from the workpiece to the tool
 *    - {axis: C, mount: table, direction: [0, 0, 1], point: [0, 0, 0], limits: unlimited, max_rpm: 20, home:
 * 0}
 *    - {axis: A, mount: table, direction: [1, 0, 0], point: [0, 20, 10], limits: [-100, 50], max_rpm: 10}
 *  linear:                    # optional, each
 *    X: {limits: [-200, 200], max_feed: 12000}
 *  work_zero: [0, 0, 0]       # optional from here on
 *  tool_length: 0
 *  rtcp: true
 *  retract_z: 300
 *  path_tolerance: 0.01
 *  \endcode
 *  Required for a rotary axis: axis, mount (table or head), direction, limits, max_rpm.
 *  \throw FileError with the line and what is missing or wrong, or what checkMachine finds */
Machine readMachine(const std::string& file);

} // namespace pcl_spiral
