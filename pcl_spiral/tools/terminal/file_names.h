// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Names of output files, and the command line as text.
 */
#pragma once

#include <string>
#include <utility>
#include <vector>

/** .csv of part.CSV */
std::string extensionOf(const std::string& file);

/** part_lines.png of part.png and _lines */
std::string besideName(const std::string& file, const std::string& suffix);

/** An input of a run: its description, such as "the scan", and its file; empty: none. */
using InputName = std::pair<std::string, std::string>;

/** \throw UsageError if \p output is one of \p inputs */
void requireNoInput(const std::string& output, const std::vector<InputName>& inputs);

/** The command line, ready to type again; of the program's path only the name. */
std::string commandLine(int argc, const char* const* argv);
