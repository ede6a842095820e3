// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distances over a mesh, in step-overs.
 */
#pragma once

#include <pcl_spiral/spiral/impl/step_over_mesh.h>

#include <array>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** Lengths of a triangle's sides, each opposite its corner, in the mean of the metrics of its three corners. These are always the
 *  sides of a flat triangle; means taken edge by edge would not be. */
std::array<double, 3> stepOverSides(const StepOverMesh& mesh, std::size_t triangle);

/** Distance of every node from the rims, in step-overs. Fast marching over the triangles (Kimmel, Sethian 1998). A value
 *  is corrected when a shorter way is found, so obtuse triangles do no harm; a second correction of a node must be twice as large to
 *  count, and so on, which bounds the cost. Unreached nodes stay infinite. \p starts: the value along each rim, infinite to leave a
 *  rim out; empty: 0. \p progress: called with the share done at every 4096th visit of a node; false cancels, and the result is
 *  empty. */
std::vector<double> distancesFromRims(const StepOverMesh& mesh, const std::vector<double>& starts = {},
                                      const std::function<bool(double)>& progress = {});

/** |grad D| in the metric, one a triangle: 1 where \p distance is a true distance. */
std::vector<float> gradientLengths(const StepOverMesh& mesh, const std::vector<double>& distance);

/** Length of the mean of the unit gradients of \p distance in the triangles about each node: 1 where all run the same way. */
std::vector<float> gradientAgreement(const StepOverMesh& mesh, const std::vector<double>& distance);

} // namespace pcl_spiral
