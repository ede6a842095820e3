// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Job files: options by name, in YAML.
 */
#pragma once

#include "option_table.h"

#include <string>

/** The options in a YAML map of names and values, or those of the run in its JSON report. Lists become comma-separated words; a list
 * under output gives several outputs; of a report, all but the report itself. \throw UsageError for a name that is not in \p table,
 * pcl_spiral::FileError for a file that is not a map, and for a report without options */
NamedValues readJobFile(const std::string& file, const OptionTable& table);
