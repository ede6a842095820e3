// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks the tool tips of a toolpath file against its contacts.
 */
#pragma once

#include "verify/verification.h"
#include <pcl_spiral/io/toolpath_reader.h>

/** Counts the tips that differ from the tip of a ball of \p tool_radius at their contact. Files without tips pass.
 *  \return a warning, empty if all tips are right */
std::string checkTips(const pcl_spiral::ToolpathFile& file, double tool_radius, pcl_spiral::Verification& verification);
