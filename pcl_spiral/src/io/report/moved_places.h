// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Figures with their places in the coordinates of a scan.
 */
#pragma once

#include <pcl_spiral/io/report_writer.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/verify/verification.h>

#include <Eigen/Core>

namespace pcl_spiral {

/** Every place moved by \p shift, mm: out of the shifted coordinates of a run, see Scan::shift. What is said has its places as fields.
 *  @{ */
SpiralSettings movedBy(const Eigen::Vector3d& shift, SpiralSettings settings);
SpiralReport movedBy(const Eigen::Vector3d& shift, SpiralReport report);
Verification movedBy(const Eigen::Vector3d& shift, Verification verification);
RunReport movedBy(const Eigen::Vector3d& shift, RunReport report);
Vocabulary movedBy(const Eigen::Vector3d& shift, Vocabulary words); ///< that has no way of its own to show places
/** @} */

} // namespace pcl_spiral
