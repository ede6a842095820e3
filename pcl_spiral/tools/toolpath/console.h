// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The summary of a run on a terminal.
 */
#pragma once

#include "outputs.h"

/** Prints the summary; for a verbose job also the time of each stage of the \p seconds. */
void printSummary(const Job& job, const Result& result, double seconds);
