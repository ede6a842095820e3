// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What was found in a mesh, as text.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <utility>
#include <vector>

namespace pcl_spiral {

/** Each kind of MeshFinding that was repaired or left out, with its text, such as "faces turned". Those that did not occur are
 *  included, with a count of 0. */
std::vector<std::pair<const char*, MeshFinding>> mendedFindings(const MeshReport& counts);

/** "3 faces turned (first at (1, 2, 3)), 2 separate parts"; empty if nothing was done and the mesh is of one part. */
Diagnostic findingsText(const MeshReport& counts);

} // namespace pcl_spiral
