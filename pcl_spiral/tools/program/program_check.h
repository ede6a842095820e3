// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether a program of a machine can be written as it was asked for.
 */
#pragma once

#include "program_job.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

/** Whether an output is a program, by its extension: .ngc .nc */
bool isProgram(const std::string& output);
/** .apt .cls .yaml */
bool isExchange(const std::string& output);
/** CLDATA and robot frames know no way from one pass to the next. \p remedy: how to make one pass. \throw FileError */
void requireOnePass(std::size_t passes, const std::string& output, const std::string& remedy);
/** Whether a program is made, to write or to draw. */
bool hasProgram(const ProgramJob& program, const std::vector<std::string>& outputs);

/** \p given: the options that were set. \throw UsageError for a setting that is missing, out of range or contradicts
 *  another */
void checkProgram(const ProgramJob& program, const std::vector<std::string>& outputs, const std::set<std::string>& given);
