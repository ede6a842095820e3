/** \file
 *  Drive paths over a scan.
 */
#pragma once

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/toolpath/drive_pass.h>
#include <pcl_spiral/toolpath/drive_settings.h>

#include <vector>

namespace pcl_spiral {

/** Passes over the surface of finite, different \p points, as DrivePath describes them. */
Status planDrive(std::vector<Eigen::Vector3f> points, const DriveSettings& settings,
                 const ProgressCallback& progress, DrivePasses& passes, DriveReport& report);

} // namespace pcl_spiral
