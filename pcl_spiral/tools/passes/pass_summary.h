// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Prints the summary of passes.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"

#include <string>
#include <vector>

/** Prints locations, length, program, times, and the files written. */
void printPasses(const PassJob& job, const PassResult& result, const std::vector<std::string>& files, double seconds);
