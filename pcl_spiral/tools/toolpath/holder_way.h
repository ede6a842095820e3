// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Shank and holder along a spiral.
 */
#pragma once

#include "outputs.h"
#include "program/free_leads.h"

/** The tool of \p job, and how deep a point of the scan may be in it. */
LedTool toolOf(const Job& job, const pcl_spiral::SpiralReport& report);

/** Looks at shank and holder along the path of \p result, against the whole scan or mesh; without a holder at nothing. \throw
 *  pcl_spiral::FileError if one would collide, unless that is accepted: then it is a warning */
void checkHolder(const Job& job, Result& result);

/** The same for the cutting moves of \p program. */
void checkHolder(const Job& job, const pcl_spiral::MachineProgram& program, Result& result);
