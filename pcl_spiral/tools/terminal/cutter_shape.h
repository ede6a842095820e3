// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The cutter of --tool-radius, --corner-radius, --flank-length and --flank-angle.
 */
#pragma once

#include "option_table.h"

#include <pcl_spiral/core/cutter_profile.h>

#include <string>
#include <vector>

/** The four options; \p radius_help of the first. */
std::vector<Option> cutterShapeOptions(const std::string& radius_help, pcl_spiral::CutterShape& cutter);

/** Without a corner radius the cutter becomes a ball, or a tapered ball. \throw UsageError for an impossible cutter */
void completeCutter(bool corner_given, pcl_spiral::CutterShape& cutter);
