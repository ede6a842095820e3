// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a run of any program is told apart from its work.
 */
#pragma once

#include "option_table.h"

#include <set>
#include <string>
#include <vector>

/** Base of the jobs of programs. */
struct ProgramRun {
  std::set<std::string> given; ///< names of the options that were set, here or in a job file
  NamedValues options;         ///< those options with their values, for the report
  std::string command;         ///< the call as typed
  std::string config_file;
  bool verbose = false;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

/** Whether \p option was set. */
bool isGiven(const ProgramRun& run, const std::string& option);

/** --config */
Option configOption(ProgramRun& run);

/** --threads, --quiet, --help, --version */
OptionGroup runOptions(ProgramRun& run, unsigned int& threads);
