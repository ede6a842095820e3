// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From the command line and a job file to options set.
 */
#pragma once

#include "option_table.h"

#include <ostream>
#include <set>
#include <string>
#include <vector>

/** Sets the options of \p table as called; words without a name are the options \p files in that order, and what --config names is
 *  read as a job file, which the command line wins over. \return the names that were set. \throw UsageError,
 *  pcl_spiral::FileError (job file) */
std::set<std::string> setOptions(const OptionTable& table, int argc, const char* const* argv,
                                 const std::vector<std::string>& files = {"scan"});

void printOptions(std::ostream& out, const OptionTable& table);
