// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Programs whose tool comes to the path and leaves it clear of the scan.
 */
#pragma once

#include "program_job.h"

#include "planning/tool_way.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <vector>

/** A check of \p scan for \p tool. */
pcl_spiral::LeadCheck<pcl::PointXYZ> leadCheckOf(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl_spiral::LedTool& tool);

/** Looks at the moves of \p program that do not cut. Where only single points off the scan's surface are in their way, or
 *  collisions are accepted, that goes to \p warnings. \p scan_name is for messages. \throw pcl_spiral::FileError, Cancelled */
void requireFreeLeads(const std::string& scan_name, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl_spiral::LedTool& tool,
                      const pcl_spiral::MachineProgram& program, bool accepted, bool quiet, pcl_spiral::Diagnostics& warnings);
