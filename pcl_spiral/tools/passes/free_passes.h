// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Passes whose shank and holder touch nothing.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"

/** Looks at a holder, if one is given, along the passes of \p result: against all of the scan but what is left out as false echoes, or
 *  against the mesh. \throw pcl_spiral::FileError if it would collide and that is not accepted */
void requireFreePasses(const PassJob& job, PassResult& result);

/** The same for shank and holder on the cutting moves of the program of \p result. */
void requireFreeProgram(const PassJob& job, PassResult& result);
