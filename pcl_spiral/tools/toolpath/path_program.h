// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The machine program of a toolpath.
 */
#pragma once

#include "outputs.h"

/** Makes the program of the path on \p machine; the leads of the cutter do not touch the scan. \throw pcl_spiral::FileError, Cancelled */
void addProgram(const Job& job, const pcl_spiral::Machine& machine, Result& result);
