// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How a program begins and ends.
 */
#pragma once

#include <functional>
#include <string>

/** Runs \p body, which gives the program's exit code, and says on stderr what went wrong. \return that code; 1 where data or a file
 *  failed, 2 for a wrong call */
int runProgram(const std::string& name, const std::function<int()>& body);
