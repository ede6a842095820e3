// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The triangles of a surface that lie within its outlines.
 */
#pragma once

#include "outline_side.h"

#include <pcl_spiral/spiral/impl/step_over_mesh.h>

#include <vector>

namespace pcl_spiral {

/** Of \p triangles over the nodes of \p mesh the largest part that lies within the outlines, clear of them by 0.45 spacings, its
 *  free edges closed loops that touch nowhere. Handles up to twelve spacings round, as noise makes them, are cut through; fails
 *  on longer ones. */
Status trianglesWithin(const StepOverMesh& mesh, const Triangulation& triangles, const OutlineSide& side, double spacing,
                       Triangulation& kept);

} // namespace pcl_spiral
