/** \file
 *  From the command line and a job file to a job.
 */
#pragma once

#include "job.h"

#include <ostream>

/** The job, checked as far as it can be without the scan. \throw UsageError, pcl_spiral::FileError (job file)
 */
Job parseCommandLine(int argc, const char* const* argv);

void printHelp(std::ostream& out);
