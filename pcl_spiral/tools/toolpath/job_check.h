// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks of a job before any work starts.
 */
#pragma once

#include "job.h"
#include "report/picture_files.h"

/** \throw UsageError if a setting is missing, out of range or contradicts another */
void checkJob(const Job& job);

/** The pictures of an output NAME.png, NAME.png first. */
std::vector<PictureName> picturesOf(const Job& job);

/** Every file of the job: the outputs, and the further pictures of each NAME.png. */
std::vector<std::string> filesOf(const Job& job);
