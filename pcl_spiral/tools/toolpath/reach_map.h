// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The map of the largest balls that reach a surface.
 */
#pragma once

#include "job.h"

#include <pcl_spiral/surface/surface.h>

#include <string>

/** Writes x, y, z of each point of \p surface and the radius of the largest ball that reaches it, at most four tool radii, mm. The kind of
 *  \p file is that of the name in the job. \throw pcl_spiral::FileError */
void writeReachMap(const Job& job, const pcl_spiral::Surface& surface, const std::string& file);
