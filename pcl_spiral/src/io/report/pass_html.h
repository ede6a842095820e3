// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What pages of drive passes and of ridges have in common. Private to io.
 */
#pragma once

#include "html_page.h"
#include "io/cutter_text.h"

#include <pcl_spiral/io/pass_report_writer.h>

#include <string>
#include <vector>

namespace pcl_spiral {

/** What the planner knows of the passes, which are not judged. */
void addPassVerdict(HtmlPage& page, const PassPlan& plan);

/** Warnings of reading and planning, with places in the coordinates of the scan. */
std::vector<std::string> passWarnings(const RunFiles& files, const PassPlan& plan);

/** Machine and time of a program; none: nothing. */
HtmlRows programRows(const PassRun& run);

/** These rows under a heading. */
void addPassProgram(HtmlPage& page, const PassRun& run);

/** How long the stages took. */
void addPassTimes(HtmlPage& page, const PassPlan& plan);

} // namespace pcl_spiral
