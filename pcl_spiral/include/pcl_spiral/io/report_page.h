// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Texts, pictures and options of a report.
 */
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** Head and foot of a report. */
struct ReportPage {
  std::string title;   ///< such as the scan's name
  std::string made;    ///< program and time: "pcl_spiral_toolpath 0.2.0, 2025-03-01 14:05 UTC"
  std::string command; ///< the command line that made it; empty: not shown
};

/** A picture of a report. */
struct ReportPicture {
  std::string file;    ///< PNG; its bytes go into the report
  std::string caption; ///< below the picture
};

/** A part with path, stock and tool, to turn and to play in a report; made by reportScene. */
struct ReportScene;

/** Options of a program by name, with their values as given; "output" once for each file. */
using RunOptions = std::vector<std::pair<std::string, std::string>>;

} // namespace pcl_spiral
