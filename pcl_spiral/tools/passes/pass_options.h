// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options of every program that makes passes of a tool.
 */
#pragma once

#include "pass_job.h"
#include "terminal/option_table.h"

#include <string>
#include <vector>

/** How files of points are read. */
std::vector<Option> readOptions(PassJob& job);
/** What of a scan counts. */
std::vector<Option> scanOptions(PassJob& job);
Option configOption(PassJob& job);
/** \p need: what it means to leave the tool's radius out. */
OptionGroup cutterOptions(PassJob& job, const std::string& need);
Option toleranceOption(PassJob& job);
/** Of axes along a pass. */
std::vector<Option> axisOptions(PassJob& job);
OptionGroup runOptions(PassJob& job);
