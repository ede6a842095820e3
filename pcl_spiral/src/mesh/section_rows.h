// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Section lines in the order of travel. Private to mesh.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>

namespace pcl_spiral {

/** Add the lines of one row to \p passes: open ones along \p along, or against it on the way \p back. The next is the one whose
 *  start is nearest to the end of the one before. A closed one begins next to that. */
void addRow(DrivePasses lines, const Eigen::Vector3d& along, bool back, DrivePasses& passes);

/** The stretches of \p lines whose normals do not lean away from \p axis (unit); \p left_out is increased by the points of the others. */
DrivePasses facingParts(const DrivePasses& lines, const Eigen::Vector3d& axis, std::size_t& left_out);

} // namespace pcl_spiral
