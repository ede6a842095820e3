// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options for the parts of the tool above the cutter.
 */
#pragma once

#include "terminal/option_table.h"

#include <pcl_spiral/core/tool_holder.h>

#include <set>
#include <string>
#include <vector>

/** --holder */
Option holderOption(std::vector<pcl_spiral::ToolSegment>& holder);

/** --holder and --holder-clearance. */
std::vector<Option> holderOptions(std::vector<pcl_spiral::ToolSegment>& holder, double& clearance);

/** \throw UsageError for an impossible holder, or without the flank that it stands on */
void checkHolder(const std::vector<pcl_spiral::ToolSegment>& holder, double clearance, double flank_length);
