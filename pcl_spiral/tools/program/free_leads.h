// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Programs whose tool comes to the path and leaves it clear of the scan.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "program_job.h"

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/verify/lead_check.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>
#include <vector>

/** What is led through the air, and by how much it may touch. Lengths in mm. */
struct LedTool {
  pcl_spiral::CutterShape cutter;
  std::vector<pcl_spiral::ToolSegment> holder;
  double holder_clearance = 0.0;
  double tolerance = 0.05;
  unsigned int threads = 0;
};

/** A check of \p scan for \p tool. */
pcl_spiral::LeadCheck<pcl::PointXYZ> leadCheckOf(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const LedTool& tool);

/** What \p tool would do at the place of \p collision: which part of it, how deep, where. */
pcl_spiral::Diagnostic collisionText(const LedTool& tool, const pcl_spiral::LeadCollision& collision);

/** The end of a warning about collisions with echoes alone. */
constexpr const char* only_echoes =
    ": only single points off the scanned surface are there, usually false echoes; check that nothing else is there";

/** Looks at the moves of \p program that do not cut. Where only single points off the scan's surface are in their way, or
 *  collisions are accepted, that goes to \p warnings. \p scan_name is for messages. \throw pcl_spiral::FileError, Cancelled */
void requireFreeLeads(const std::string& scan_name, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const LedTool& tool,
                      const pcl_spiral::MachineProgram& program, bool accepted, bool quiet, pcl_spiral::Diagnostics& warnings);
