// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The user's settings for one run of pcl_spiral_view.
 */
#pragma once

#include "judging/judge_options.h"

#include <ostream>
#include <string>

/** The user's settings for one run. */
struct ViewJob : JudgeOptions {
  std::string scan, path; ///< path empty: the scan alone
};

/** \throw UsageError */
ViewJob parseViewCommandLine(int argc, const char* const* argv);

void printViewHelp(std::ostream& out);
