// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes a path from a scan or mesh file.
 */
#pragma once

#include "outputs.h"

/** \throw pcl_spiral::FileError or UsageError with the program's option names, Cancelled, unless \p status is Ok */
void requireOk(const Job& job, const pcl_spiral::Status& status);

/** Reads the scan or the mesh and makes the path. \throw as requireOk */
Result plan(const Job& job);
