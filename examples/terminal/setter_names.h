/** \file
 *  Messages of the library in a program's words.
 */
#pragma once

#include <string>
#include <vector>

/** \p message with the library's setters, such as setThinning, replaced by the options that call them, --thin. */
std::string inOptions(std::string message);

std::vector<std::string> inOptions(std::vector<std::string> messages);
