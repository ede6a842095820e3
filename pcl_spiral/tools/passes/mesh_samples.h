// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points of a mesh.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"

/** Sets the points of the mesh in \p result, for checks that need points: leads of a program, ends of a column. \throw UsageError,
 *  pcl_spiral::FileError, Cancelled */
void sampleMesh(const PassJob& job, PassResult& result);
