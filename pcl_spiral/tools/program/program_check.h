// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks of the settings of a machine program.
 */
#pragma once

#include "program_job.h"

#include <set>
#include <string>
#include <vector>

/** Whether an output is a program, by its extension: .ngc .nc .mpf .h */
bool isProgram(const std::string& output);
/** The language of a program: a .ngc is always for LinuxCNC, a .mpf for Siemens, a .h for Heidenhain. */
pcl_spiral::Dialect languageOf(const ProgramJob& program, const std::string& output);
/** .apt .cls .yaml */
bool isExchange(const std::string& output);
/** Whether one of the \p outputs is such a file. */
bool hasExchange(const std::vector<std::string>& outputs);
/** Whether a program is made, for a file or a picture. */
bool hasProgram(const ProgramJob& program, const std::vector<std::string>& outputs);
/** Whether the tool is led to the passes and off them, in a program or in files for other machines. */
bool hasLeads(const ProgramJob& program, const std::vector<std::string>& outputs);

/** \p given: the options that were set. \throw UsageError if a setting is missing, out of range or contradicts
 *  another */
void checkProgram(const ProgramJob& program, const std::vector<std::string>& outputs, const std::set<std::string>& given);
