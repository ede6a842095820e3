/** \file
 *  Jobs of pcl_spiral_drive that cannot be meant.
 */
#pragma once

#include "job.h"

/** Whether the cutter is a ball, whose tip follows from its contact. */
bool isBall(const Job& job);

/** Fills in what follows from other options: a ball's corner, the step-over of a scallop. \throw UsageError for a
 *  setting that is missing, out of range or contradicts another */
void completeJob(Job& job);
