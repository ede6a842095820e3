// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options on how the file of a scan is read.
 */
#pragma once

#include "option_table.h"

#include <pcl_spiral/io/cloud_reader.h>

#include <cstddef>
#include <string>
#include <vector>

/** Help on --columns, --skip-lines and --raw-scan, for all programs. */
extern const char* const columns_help;
extern const char* const skip_lines_help;
extern const char* const raw_scan_help;

/** ".pcd .ply .xyz", and so on: the extensions of scans. */
std::string scanExtensions();

/** The number of --skip-lines. \throw UsageError */
std::size_t skipLinesValue(const std::string& value);

/** --units, --origin, --columns and --skip-lines. */
std::vector<Option> readOptions(pcl_spiral::ReadOptions& read);
