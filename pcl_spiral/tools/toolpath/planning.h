// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From the file to a path.
 */
#pragma once

#include "outputs.h"

/** \throw pcl_spiral::FileError or UsageError in the words of the program, Cancelled, unless \p status is Ok */
void requireOk(const Job& job, const pcl_spiral::Status& status);

/** Read the scan or the mesh and make the path. \throw as requireOk */
Result plan(const Job& job);
