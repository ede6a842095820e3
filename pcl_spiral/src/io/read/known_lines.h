// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines of a program that the machine file gives.
 */
#pragma once

#include <pcl_spiral/machine/machine.h>

#include <string_view>

namespace pcl_spiral {

/** \p line without its number, N10 or 10, and without spaces around. */
std::string_view lineWithoutNumber(std::string_view line);

/** Whether \p line is one of the shop's, with values for its names, or a word of the control for coolant or smoothing. What it does is the
 *  shop's affair: it is not followed. */
bool isShopLine(const Machine& machine, std::string_view line);

} // namespace pcl_spiral
