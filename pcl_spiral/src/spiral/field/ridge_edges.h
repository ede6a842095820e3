// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Edges of a mesh along the ridges of a distance.
 */
#pragma once

#include "step_over_march.h"

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Gives \p mesh edges along the ridges of \p marched, between nodes marked in \p may_cross, one a node. Over a triangle that a ridge
 *  crosses, values at its corners alone say nothing of how high the ridge is, or where: with edges along it they do, and the mesh need
 *  not be fine. A ridge crosses an edge where the planes of the two fronts meet that came to its ends. Nodes are added there, and halfway
 *  between two of them, or one and the corner that faces it; nothing came over a ridge, so all other distances stay. The new nodes are
 *  marked. Which side a front crossed last is not known any more. */
StepOverMesh withRidgeEdges(StepOverMesh mesh, MarchedDistances& marched, std::vector<std::uint8_t>& may_cross);

} // namespace pcl_spiral
