// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for one run of pcl_spiral_view.
 */
#pragma once

#include "judging/filed_path.h"
#include "judging/judge_options.h"

#include <pcl_spiral/core/tool_holder.h>

#include <ostream>
#include <string>
#include <vector>

/** The user's settings for one run. */
struct ViewJob : JudgeOptions, ProgramReading {
  std::string scan, path;                      ///< path empty: the scan alone
  std::vector<pcl_spiral::ToolSegment> holder; ///< above the flank, upwards
};

/** \throw UsageError */
ViewJob parseViewCommandLine(int argc, const char* const* argv);

void printViewHelp(std::ostream& out);
