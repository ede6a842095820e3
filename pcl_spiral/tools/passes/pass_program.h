// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The machine program of passes.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "pass_job.h"
#include "pass_result.h"

/** Makes the program of the passes on \p machine; the leads of a cutter do not touch the scan in \p result.
 *  \throw pcl_spiral::FileError, Cancelled */
void addProgram(const PassJob& job, const pcl_spiral::Machine& machine, PassResult& result);

/** Changes \p job to what \p change asks of the path or the program, to plan it again. Returns whether it changes anything. */
bool changeFor(pcl_spiral::MotionChange change, const pcl_spiral::Machine& machine, PassJob& job);

/** Adds leads to the passes for CLDATA and robot frames. They do not touch the scan, either; if there is a program, its own leads have been
 *  checked. \throw pcl_spiral::FileError, Cancelled */
void addMoves(const PassJob& job, PassResult& result);

/** Nothing: passes are judged by a run of pcl_spiral_verify. */
inline void
judge(const PassJob&, PassResult&)
{}

inline const pcl_spiral::Diagnostics&
warningsOf(const PassResult& result)
{
  return result.warnings;
}
