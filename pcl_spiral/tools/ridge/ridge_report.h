// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The JSON report of pcl_spiral_ridge.
 */
#pragma once

#include "planning.h"

/** \throw pcl_spiral::FileError */
void writeRidgeReport(const std::string& file, const Job& job, const Result& result);
