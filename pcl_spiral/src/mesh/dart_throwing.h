// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Candidates thinned to points that keep a distance. Private to mesh.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** A place that may be taken. Those of priority 0 are always taken. */
struct Dart {
  Eigen::Vector3f position;
  std::uint32_t priority;
};

/** The darts taken of \p darts: each unless one of a lower priority is nearer than \p distance. Between cells of the grid the
 *  order is that of the cells' colours. Indices in the order of the cells, the same for any number of threads and any
 *  order of the darts. */
std::vector<std::uint32_t> throwDarts(const std::vector<Dart>& darts, double distance);

/** Most cells along the longest side of the box about \p low and \p high that throwDarts can distinguish. */
constexpr double most_dart_cells = 2e6;

} // namespace pcl_spiral
