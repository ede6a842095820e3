// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The map of the largest balls that reach a surface.
 */
#pragma once

#include "outputs.h"

#include <string>

/** Writes x, y, z of each point of the surface of \p result, or of its regions, and the radius of the largest ball that reaches it, at
 *  most four tool radii, mm. The kind of \p file is that of the name in the job. \throw pcl_spiral::FileError */
void writeReachMap(const Job& job, const Result& result, const std::string& file);
