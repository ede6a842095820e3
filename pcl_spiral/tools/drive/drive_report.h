// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The JSON report of pcl_spiral_drive.
 */
#pragma once

#include "planning.h"

/** JSON: settings, counts, states, collisions, times. \throw pcl_spiral::FileError */
void writeDriveReport(const std::string& file, const Job& job, const Result& result);
