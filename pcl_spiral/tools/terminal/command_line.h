// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Sets options from the command line and a job file.
 */
#pragma once

#include "option_table.h"

#include <ostream>
#include <set>
#include <string>
#include <vector>

/** Sets the options of \p table from the command line; words without a name are the options \p files in that order. The file of
 *  --config is read as a job file; the command line has priority. \return the names that were set. \throw UsageError,
 *  pcl_spiral::FileError (job file) */
std::set<std::string> setOptions(const OptionTable& table, int argc, const char* const* argv,
                                 const std::vector<std::string>& files = {"scan"});

void printOptions(std::ostream& out, const OptionTable& table);
