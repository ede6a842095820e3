// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The summary of a run on a terminal.
 */
#pragma once

#include "outputs.h"

/** What was made, for people; a verbose job is told what each stage of the \p seconds cost. */
void printSummary(const Job& job, const Result& result, double seconds);
