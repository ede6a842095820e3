// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Messages of the library with a program's option names.
 */
#pragma once

#include <string>
#include <vector>

/** Whether the program has that option, named without the dashes. Each program defines it from its own options. */
bool hasOption(const std::string& name);

/** \p message with the library's setters, such as setThinning, replaced by the options that call them, --thin. If the program
 *  has no such option, the brackets that name the setter are removed. A word in a path or file name does not change. */
std::string inOptions(std::string message);

std::vector<std::string> inOptions(std::vector<std::string> messages);
