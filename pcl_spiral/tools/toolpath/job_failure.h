// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Failures of the library in the words of the program.
 */
#pragma once

#include "job.h"

#include <pcl_spiral/common/status.h>

#include <string>

/** A message of the library with the program's option names, and with a mesh's words if the job has a mesh. */
std::string inWords(const Job& job, const std::string& message);

/** \throw pcl_spiral::FileError or UsageError with the program's option names, Cancelled, unless \p status is Ok */
void requireOk(const Job& job, const pcl_spiral::Status& status);
