// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Jobs of pcl_spiral_ridge that cannot be meant.
 */
#pragma once

#include "job.h"

#include <string>
#include <vector>

/** The files of all outputs, in the job's order: beside part.png part_lines.png, part_normals.png and, where there is a program,
 *  part_rotary.png. */
std::vector<std::string> filesOf(const Job& job);

/** Fills in what follows from other options. \throw UsageError for a setting that is missing, out of range or contradicts another */
void completeJob(Job& job);
