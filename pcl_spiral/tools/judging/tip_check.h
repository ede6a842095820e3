// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The tool tips of a toolpath file held against its contacts.
 */
#pragma once

#include "io/report/verification_writer.h"
#include <pcl_spiral/io/toolpath_reader.h>

/** Count the tips that do not stand where a ball of \p tool_radius touches at their contact, and say so. Files without
 *  tips pass. \return a warning, empty when all fit */
std::string checkTips(const pcl_spiral::ToolpathFile& file, double tool_radius, pcl_spiral::Verification& verification);
