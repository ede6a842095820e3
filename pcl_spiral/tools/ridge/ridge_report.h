// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A run of pcl_spiral_ridge for programs to read.
 */
#pragma once

#include "planning.h"

/** \throw pcl_spiral::FileError */
void writeRidgeReport(const std::string& file, const Job& job, const Result& result);
