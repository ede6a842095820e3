// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The map of the largest balls that reach a surface.
 */
#pragma once

#include "outputs.h"

#include <string>

/** Points of a surface, and for each the radius of the largest ball that reaches it, at most \ref largest; mm. */
struct ReachMap {
  pcl_spiral::Polyline places;
  std::vector<float> radii;
  double largest = 0.0; ///< four tool radii
};

/** Of the surface of \p result, or of its regions. */
ReachMap reachMapOf(const Job& job, const Result& result);

/** Writes the map as x, y, z and radius of each point. \p extension: .csv, .pcd or .ply. \throw pcl_spiral::FileError */
void writeReachMap(const ReachMap& map, const std::string& extension, const std::string& file);
