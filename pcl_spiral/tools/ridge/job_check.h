// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks of a job of pcl_spiral_ridge.
 */
#pragma once

#include "job.h"

#include <string>
#include <vector>

/** The files of all outputs, in the job's order; with part.png also part_lines.png, part_normals.png and, if there is a program,
 *  part_rotary.png. */
std::vector<std::string> filesOf(const Job& job);

/** Sets what follows from other options. \throw UsageError if a setting is missing, out of range or contradicts another */
void completeJob(Job& job);
