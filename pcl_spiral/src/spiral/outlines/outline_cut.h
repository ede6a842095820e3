// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The triangles of a surface that lie within its outlines.
 */
#pragma once

#include "outline_side.h"

#include <pcl_spiral/spiral/impl/step_over_mesh.h>

#include <vector>

namespace pcl_spiral {

/** The largest part of \p triangles over the nodes of \p mesh that lies within the outlines, at least 0.45 spacings from them. Its
 *  free edges are closed loops that never touch. Handles up to twelve spacings round, which come from noise, are cut through; it
 *  fails on longer ones. */
Status trianglesWithin(const StepOverMesh& mesh, const Triangulation& triangles, const OutlineSide& side, double spacing,
                       Triangulation& kept);

} // namespace pcl_spiral
