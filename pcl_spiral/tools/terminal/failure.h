// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Failures of the library as exceptions of the program.
 */
#pragma once

#include <pcl_spiral/common/status.h>

#include <string>

/** Turns a stage's failure into an exception that names \p file. \throw UsageError, pcl_spiral::FileError, Cancelled */
void require(const std::string& file, const pcl_spiral::Status& status);
