// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The machine program of a toolpath.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "outputs.h"

/** Makes the program of the path on \p machine; the leads of the cutter do not touch the scan. \throw pcl_spiral::FileError, Cancelled */
void addProgram(const Job& job, const pcl_spiral::Machine& machine, Result& result);

/** Changes \p job to what \p change asks of the path or the program, to plan it again. Returns whether it changes anything. */
bool changeFor(pcl_spiral::MotionChange change, const pcl_spiral::Machine& machine, Job& job);

/** Adds leads to the path for CLDATA and robot frames. They do not touch the scan, either; if there is a program, its own leads have been
 *  checked. \throw pcl_spiral::FileError, Cancelled */
void addMoves(const Job& job, Result& result);

/** Looks at the ways of the tool between the regions of a path, as a program would make them. A path file has no links: its tool is lifted
 *  by the program that reads it. \throw pcl_spiral::FileError if the tool would touch the scan, Cancelled */
void checkLinks(const Job& job, Result& result);
