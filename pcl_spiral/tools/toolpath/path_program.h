// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The machine program of a toolpath.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "outputs.h"

/** Makes the program of the path on \p machine; the leads of the cutter do not touch the scan. \throw pcl_spiral::FileError, Cancelled */
void addProgram(const Job& job, const pcl_spiral::Machine& machine, Result& result);

/** Adds leads to the path for CLDATA and robot frames. They do not touch the scan, either; if there is a program, its own leads have been
 *  checked. \throw pcl_spiral::FileError, Cancelled */
void addMoves(const Job& job, Result& result);

/** The program of \p passes over everything in the scan, with nothing of it in the way of the leads. Warnings of its making go to
 *  \p made, those about echoes to the report. \throw pcl_spiral::FileError, Cancelled */
pcl_spiral::MachineProgram freeProgram(const Job& job, const pcl_spiral::Machine& machine, const std::vector<pcl_spiral::ToolPoses>& passes,
                                       Result& result, pcl_spiral::Diagnostics& made);
