// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks of the settings of a machine program.
 */
#pragma once

#include "program_job.h"

#include <cstddef>
#include <set>
#include <string>
#include <vector>

/** Whether an output is a program, by its extension: .ngc .nc */
bool isProgram(const std::string& output);
/** The language of a program: a .ngc is always for LinuxCNC. */
pcl_spiral::Dialect languageOf(const ProgramJob& program, const std::string& output);
/** .apt .cls .yaml */
bool isExchange(const std::string& output);
/** CLDATA and robot frames have no moves from one pass to the next. \p remedy: how to make one pass. \throw FileError */
void requireOnePass(std::size_t passes, const std::string& output, const std::string& remedy);
/** Whether a program is made, for a file or a picture. */
bool hasProgram(const ProgramJob& program, const std::vector<std::string>& outputs);

/** \p given: the options that were set. \throw UsageError if a setting is missing, out of range or contradicts
 *  another */
void checkProgram(const ProgramJob& program, const std::vector<std::string>& outputs, const std::set<std::string>& given);
