// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Turns the command line into a job.
 */
#pragma once

#include "job.h"

#include <ostream>

/** The job from the command line and its job file, checked. \throw UsageError, pcl_spiral::FileError (job file)
 */
Job parseCommandLine(int argc, const char* const* argv);

void printHelp(std::ostream& out);
