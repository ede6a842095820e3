// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Texts and pictures of a readable report.
 */
#pragma once

#include <string>

namespace pcl_spiral {

/** Head and foot of a report. */
struct ReportPage {
  std::string title;   ///< such as the scan's name
  std::string made;    ///< program and time: "pcl_spiral_toolpath 0.1.0, 2025-03-01 14:05 UTC"
  std::string command; ///< the command line that made it; empty: not shown
};

/** A picture of a report. */
struct ReportPicture {
  std::string file; ///< PNG; its bytes go into the report
  std::string caption;
};

} // namespace pcl_spiral
