// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Programs that link passes near the surface where the way is free.
 */
#pragma once

#include "free_leads.h"
#include "program_job.h"

#include <functional>
#include <string>
#include <vector>

/** Makes a program with \p make, which is given the passes before which the tool retracts. If the job asks for links, each one keeps half
 *  the lead length from every point of \p scan, or the tool retracts there. \p scan_name is for messages. \throw pcl_spiral::FileError,
 *  Cancelled */
pcl_spiral::MachineProgram linkedProgram(const ProgramJob& job,
                                         const std::function<pcl_spiral::MachineProgram(const std::vector<std::size_t>& retracted)>& make,
                                         const std::string& scan_name, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan,
                                         const pcl_spiral::LedTool& tool);
