// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks of a job of pcl_spiral_drive.
 */
#pragma once

#include "job.h"

/** The files of all outputs, in the job's order; with part.png also part_rotary.png if there is a program. */
std::vector<std::string> filesOf(const Job& job);

/** Sets what follows from other options: a ball's corner, the step-over of a scallop. \throw UsageError if a
 *  setting is missing, out of range or contradicts another */
void completeJob(Job& job);
