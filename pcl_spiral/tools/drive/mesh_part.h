// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A mesh as the part.
 */
#pragma once

#include "planning.h"

#include <pcl_spiral/common/drive_pass.h>

/** Reads and prepares the mesh, and reports what was found in it. \throw UsageError, pcl_spiral::FileError, Cancelled */
void readMeshPart(const Job& job, Result& result);

/** The cutter at the given contacts, without a check for gouges. */
std::vector<pcl_spiral::ToolLocations> standAtContacts(const Job& job, const pcl_spiral::DrivePasses& passes);
