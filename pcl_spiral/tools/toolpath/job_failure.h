// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Failures of the library as exceptions of the program.
 */
#pragma once

#include "job.h"

#include <pcl_spiral/common/status.h>

/** \throw pcl_spiral::FileError or UsageError with what \p status says, Cancelled, unless \p status is Ok */
void requireOk(const Job& job, const pcl_spiral::Status& status);
