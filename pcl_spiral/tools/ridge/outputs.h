// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a run of pcl_spiral_ridge leaves behind.
 */
#pragma once

#include "planning.h"

#include "io/output_files.h"

/** Writes all outputs, or none. \throw std::runtime_error, Cancelled */
void writeOutputs(const Job& job, const Result& result, pcl_spiral::OutputFiles& files);

/** What came of it, for people. */
void printSummary(const Job& job, const Result& result, double seconds);
