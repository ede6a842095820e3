// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Jobs of pcl_spiral_drive that cannot be meant.
 */
#pragma once

#include "job.h"

/** The files of all outputs, in the job's order: beside part.png part_rotary.png, where there is a program. */
std::vector<std::string> filesOf(const Job& job);

/** Fills in what follows from other options: a ball's corner, the step-over of a scallop. \throw UsageError for a
 *  setting that is missing, out of range or contradicts another */
void completeJob(Job& job);
