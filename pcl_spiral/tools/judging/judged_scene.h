// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The scene of a judged path, for pictures and the viewer.
 */
#pragma once

#include <pcl_spiral/planning/impl/path_judging.h>

#include <pcl_spiral/visualization/verification_pictures.h>

/** \p surface is that of the scan. The title is the path's file name. */
pcl_spiral::VerificationScene judgedScene(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan,
                                          const pcl::PointCloud<pcl_spiral::ToolpathPoint>::ConstPtr& path,
                                          const pcl_spiral::JudgeSettings& settings, const pcl_spiral::ReferenceSurface& surface,
                                          const pcl_spiral::Verification& verification, const pcl_spiral::Heights& heights);
