/** \file
 *  Names of output files, and the call as words.
 */
#pragma once

#include <string>

/** .csv of part.CSV */
std::string extensionOf(const std::string& file);

/** part_lines.png of part.png and _lines */
std::string besideName(const std::string& file, const std::string& suffix);

/** The call as it can be typed again; of the program its name alone. */
std::string commandLine(int argc, const char* const* argv);
