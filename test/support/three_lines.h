// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The earlier method for measuring a ridge: three long lines, an arc through them at each station.
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_spiral::test {

/** The lines along the whole rail through start, middle and end of the generator; points with the same index belong to one
 *  station. */
struct ThreeLines {
  std::array<std::vector<Eigen::Vector3d>, 3> lines;

  std::size_t stations() const { return lines[0].size(); }
  /** Point on the arc through the three points of a station, at the share \p w of its angle from start to end. */
  Eigen::Vector3d position(std::size_t station, double w) const;
};

} // namespace pcl_spiral::test
