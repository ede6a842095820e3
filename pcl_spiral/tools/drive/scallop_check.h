// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether passes leave no more than the scallop height asked for.
 */
#pragma once

#include "planning.h"

#include <pcl_spiral/surface/surface.h>

/** Of the scallop height asked for: what passes may leave, for the errors of its measure. */
constexpr double more_left = 1.1;

/** Moves the cutter along its passes and measures what it leaves over the surface of the scan, or over the mesh. Refuses passes that
 *  leave more than --scallop and --tolerance on more than a fiftieth of it, and warns where they do on less. Warns, also without
 *  --scallop, where rows of a fixed axis do not reach more than a fiftieth of a scan. \p surface is null for a mesh, and for points
 *  that form no surface. \throw pcl_spiral::FileError with the height, the place and the share */
void requireScallop(const Job& job, const pcl_spiral::Surface::ConstPtr& surface, Result& result);
