// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Start and end of a program.
 */
#pragma once

#include <functional>
#include <string>

/** Runs \p body, which returns the program's exit code, and reports errors on stderr. \return that code; 1 if data or a file
 *  failed, 2 for a wrong command line */
int runProgram(const std::string& name, const std::function<int()>& body);
