// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks the tool tips of a toolpath file against its contacts.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/verify/verification.h>

/** Counts the tips of a ball that differ from the tip at their contact, and those of another cutter whose side is not at their contact.
 *  Files without tips pass. \return a warning, empty if all tips are right */
pcl_spiral::Diagnostic checkTips(const pcl_spiral::ToolpathFile& file, const pcl_spiral::CutterShape& cutter,
                                 pcl_spiral::Verification& verification);
