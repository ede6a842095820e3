// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A mesh as the part to drive over.
 */
#pragma once

#include "planning.h"

#include <pcl_spiral/common/drive_pass.h>

/** Reads the mesh, makes it ready, and tells what was found in it. \throw UsageError, pcl_spiral::FileError, Cancelled */
void readMeshPart(const Job& job, Result& result);

/** The cutter at the contacts asked for, unchecked. */
std::vector<pcl_spiral::ToolLocations> standAtContacts(const Job& job, const pcl_spiral::DrivePasses& passes);
