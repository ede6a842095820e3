// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The discrete Laplace equation on the edges of a triangulation.
 */
#pragma once

#include <pcl_spiral/graph/impl/triangulation.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** A function of the points of a triangulation, known on some of them, harmonic on the others. */
struct LaplaceProblem {
  static constexpr std::uint32_t known = Triangulation::none;

  std::vector<std::uint32_t> unknown; ///< of each point: its unknown (points may share one), or known
  std::size_t unknowns = 0;
  Eigen::MatrixXd values;   ///< one row per point, one column per right-hand side; rows of known points are given
  std::vector<double> rise; ///< of each half-edge: what the function grows along it beyond the difference of
                            ///< its values (a cut of a many-valued function); empty: nothing
};

/** Fill in the rows of the unknown points. \p edges: half-edges to count, one per edge; \p weight of each half-edge.
 *  Sparse Cholesky; above 300,000 unknowns conjugate gradients with an incomplete factorisation.
 *  \return false if the equations are singular or the iteration did not converge.
 */
bool solve(const Triangulation& mesh, const std::vector<std::uint32_t>& edges, const std::vector<double>& weight, LaplaceProblem& problem);

} // namespace pcl_spiral
