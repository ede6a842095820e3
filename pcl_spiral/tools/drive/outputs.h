// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The files of a run of pcl_spiral_drive.
 */
#pragma once

#include "planning.h"

#include "io/output_files.h"

/** Writes every file of the job, all or none. \throw pcl_spiral::FileError, Cancelled */
void writeOutputs(const Job& job, const Result& result, pcl_spiral::OutputFiles& files);

/** What the run came to, for people. */
void printSummary(const Job& job, const Result& result, double seconds);
