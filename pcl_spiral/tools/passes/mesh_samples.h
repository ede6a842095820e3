// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A mesh as points.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"

/** Points of the mesh in \p result for what looks at points: leads of a program, ends of a column. \throw UsageError,
 *  pcl_spiral::FileError, Cancelled */
void sampleMesh(const PassJob& job, PassResult& result);
