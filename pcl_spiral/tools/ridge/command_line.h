// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The command line of pcl_spiral_ridge.
 */
#pragma once

#include "job.h"

#include <ostream>

/** \throw UsageError, pcl_spiral::FileError (job file) */
Job parseCommandLine(int argc, const char* const* argv);

void printHelp(std::ostream& out);
