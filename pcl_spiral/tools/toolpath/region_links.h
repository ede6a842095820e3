// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The ways of the tool from region to region.
 */
#pragma once

#include "outputs.h"

/** Leads the tool off the end of each pass of a path of several regions, up over the highest point of the scan, across, and down to the
 *  next pass, as a program would, and looks for the scan on the way. A path file has no links: its tool is lifted by the program that
 *  reads it. \throw pcl_spiral::FileError if the tool would touch the scan, unless --accept-collisions is given: then it is a warning */
RegionLinks checkedLinks(const Job& job, Result& result);

/** Number and height of the links of a path of several regions, from its program. */
RegionLinks linksOf(const Result& result, const pcl_spiral::MachineProgram& program);
