// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The output files of pcl_spiral_ridge.
 */
#pragma once

#include "planning.h"

#include <pcl_spiral/io/output_files.h>

/** Writes all outputs or none. \throw std::runtime_error, Cancelled */
void writeOutputs(const Job& job, const Result& result, pcl_spiral::OutputFiles& files);

/** Prints a summary of the run. */
void printSummary(const Job& job, const Result& result, double seconds);
