// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Distances over a mesh, in step-overs.
 */
#pragma once

#include <pcl_spiral/spiral/impl/step_over_mesh.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** Lengths of a triangle's sides, each opposite its corner, in the mean of the metrics of its three corners. These are always the
 *  sides of a flat triangle; means taken edge by edge would not be. */
std::array<double, 3> stepOverSides(const StepOverMesh& mesh, std::size_t triangle);

/** Distances from the rims, and over which nodes they came. Parallel arrays, one entry a node. */
struct MarchedDistances {
  using Side = std::array<std::uint32_t, 2>;

  std::vector<double> distance; ///< step-overs; infinite where not known
  std::vector<Side> over;       ///< ends of the side that the front crossed last, twice the same along an edge; none on rims

  void resize(std::size_t nodes); ///< Those added are not known.
};

/** Distance of every node from the rims, in step-overs, from \p starts[r] on rim r on; infinite leaves a rim out. Fast marching over the
 *  triangles (Kimmel, Sethian 1998). A value is corrected when a shorter way is found, so obtuse triangles do no harm; a second
 *  correction of a node must be twice as large to count, and so on, which bounds the cost. Unreached nodes stay infinite. Nodes settle in
 *  rounds, a quarter of an edge of the front at a time: all of a round look in parallel for shorter ways to their neighbours before any
 *  is taken, so the result does not depend on the threads. */
std::vector<double> distancesFromRims(const StepOverMesh& mesh, const std::vector<double>& starts);

/** The same from 0 on all rims, for the infinite entries of \p marched alone, from its others, which may become shorter. If it has fewer
 *  entries than \p mesh nodes, the last are infinite. \p progress: called with the share done after some thousand visits of nodes; false
 *  cancels, and this returns false. */
bool marchOn(const StepOverMesh& mesh, MarchedDistances& marched, const std::function<bool(double)>& progress = {});

/** Make infinite the distances at the corners of \p chosen triangles, which are to be cut, and all that came over these nodes. Those on
 *  rims stay. */
void forgetBehind(const StepOverMesh& mesh, const std::vector<std::uint8_t>& chosen, MarchedDistances& marched);

/** |grad D| in the metric, one a triangle: 1 where \p distance is a true distance. */
std::vector<float> gradientLengths(const StepOverMesh& mesh, const std::vector<double>& distance);

/** Length of the mean of the unit gradients of \p distance in the triangles about each node: 1 where all run the same way. */
std::vector<float> gradientAgreement(const StepOverMesh& mesh, const std::vector<double>& distance);

} // namespace pcl_spiral
