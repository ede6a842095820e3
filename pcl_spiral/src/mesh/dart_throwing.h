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

/** A place that may be taken. Those of priority 0 are, whatever lies near. */
struct Dart {
  Eigen::Vector3f position;
  std::uint32_t priority;
};

/** Of \p darts those taken: each unless one of a lower priority lies nearer than \p distance; between cells of the grid the
 *  order is that of the cells' colours. Indices in the order of the cells, the same for any number of threads and whatever the
 *  order of the darts. */
std::vector<std::uint32_t> throwDarts(const std::vector<Dart>& darts, double distance);

/** Cells along the longest side of the box about \p low and \p high that throwDarts can tell apart. */
constexpr double most_dart_cells = 2e6;

} // namespace pcl_spiral
