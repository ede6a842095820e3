// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Axes of passes, smoothed along them.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "pass_job.h"

#include <pcl_spiral/common/drive_pass.h>

#include <optional>

/** Smooths the axes of each pass along it and limits their turn, if the job asks for that. With the \p stand_off of a beam its spots stay
 *  where they are. \throw UsageError if an axis would be too far from the one asked for */
void smoothPasses(const PassJob& job, pcl_spiral::DrivePasses& passes, pcl_spiral::Diagnostics& warnings,
                  const std::optional<double>& stand_off = std::nullopt);
