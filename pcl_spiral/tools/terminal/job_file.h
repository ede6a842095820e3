// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Job files: options by name, in YAML.
 */
#pragma once

#include "option_table.h"

#include <string>
#include <utility>
#include <vector>

/** Options by name with their values, as on the command line. */
using NamedValues = std::vector<std::pair<std::string, std::string>>;

/** The options in a YAML map of names and values. Lists become comma-separated words; a list under output
 * gives several outputs. \throw UsageError for a name that is not in \p table, pcl_spiral::FileError for a
 * file that is not a map */
NamedValues readJobFile(const std::string& file, const OptionTable& table);
