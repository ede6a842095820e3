// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What is wrong with a job before any work starts.
 */
#pragma once

#include "job.h"
#include "report/picture_files.h"

/** \throw UsageError for a setting that is missing, out of range or contradicts another */
void checkJob(const Job& job);

/** The pictures of an output NAME.png, itself first. */
std::vector<PictureName> picturesOf(const Job& job);

/** Every file the job makes: the outputs, and the pictures beside each NAME.png. */
std::vector<std::string> filesOf(const Job& job);
