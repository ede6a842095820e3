// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Messages of the library in a program's words.
 */
#pragma once

#include <string>
#include <vector>

/** Whether the program has that option, named without the dashes. Each program defines it, from its own options. */
bool hasOption(const std::string& name);

/** \p message with the library's setters, such as setThinning, replaced by the options that call them, --thin. Where the program
 *  has no such option, the brackets that name the setter go. A word inside a path or file name stays as it is. */
std::string inOptions(std::string message);

std::vector<std::string> inOptions(std::vector<std::string> messages);
