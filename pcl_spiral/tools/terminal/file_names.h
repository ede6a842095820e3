// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Names of output files, and the call as words.
 */
#pragma once

#include <string>
#include <utility>
#include <vector>

/** .csv of part.CSV */
std::string extensionOf(const std::string& file);

/** part_lines.png of part.png and _lines */
std::string besideName(const std::string& file, const std::string& suffix);

/** An input of a run: what it is, "the scan", and its file; empty: none. */
using InputName = std::pair<std::string, std::string>;

/** \throw UsageError where \p output is one of \p inputs */
void requireNoInput(const std::string& output, const std::vector<InputName>& inputs);

/** The call as it can be typed again; of the program its name alone. */
std::string commandLine(int argc, const char* const* argv);
