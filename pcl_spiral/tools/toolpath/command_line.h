// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From the command line to a job.
 */
#pragma once

#include "job.h"

#include <ostream>

/** The job as called, with what its job file says; checked. \throw UsageError, pcl_spiral::FileError (job file)
 */
Job parseCommandLine(int argc, const char* const* argv);

void printHelp(std::ostream& out);
