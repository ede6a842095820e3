// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The option for the surface after cutting.
 */
#pragma once

#include "terminal/option_table.h"

#include <string>
#include <vector>

/** --stock */
Option stockOption(std::vector<std::string>& files);

/** \throw UsageError for another extension */
void checkStockFiles(const std::vector<std::string>& files);
