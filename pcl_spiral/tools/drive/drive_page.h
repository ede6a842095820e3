// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The HTML report of pcl_spiral_drive.
 */
#pragma once

#include "planning.h"

#include <pcl_spiral/io/report_page.h>

#include <string>
#include <vector>

/** One HTML file that needs no other: pictures, path, part, warnings, settings, times. \throw pcl_spiral::FileError */
void writeDrivePage(const std::string& file, const std::string& title, const Job& job, const Result& result,
                    const std::vector<pcl_spiral::ReportPicture>& pictures);
