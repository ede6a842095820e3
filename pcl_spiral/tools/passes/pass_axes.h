// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Axes of passes, smoothed along them.
 */
#pragma once

#include "pass_job.h"

#include <pcl_spiral/common/drive_pass.h>

#include <string>
#include <vector>

/** Smooths the axes of each pass along it and holds them to the rate, where the job asks for that. \throw UsageError where axes
 *  would lean too far off those asked for */
void smoothPasses(const PassJob& job, pcl_spiral::DrivePasses& passes, std::vector<std::string>& warnings);
