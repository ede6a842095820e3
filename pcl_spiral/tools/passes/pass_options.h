// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options that all programs for passes of a tool share.
 */
#pragma once

#include "pass_job.h"
#include "terminal/option_table.h"

#include <string>
#include <vector>

/** Options that select the points of a scan. */
std::vector<Option> scanOptions(PassJob& job);
/** Cutter and holder. \p need: help text that explains what happens without the tool's radius. */
OptionGroup cutterOptions(PassJob& job, const std::string& need);
/** Locations, moves and axes of a cutter or a beam. */
OptionGroup motionOptions(PassJob& job);
/** How the program runs, and --verbose. */
OptionGroup runOptions(PassJob& job);
