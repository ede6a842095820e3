// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The earlier method to measure a ridge: three long lines, an arc through them at each station.
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace pcl_spiral::test {

/** The lines along the whole rail that start, middle and end of the generator run; points of the same number in the list are one
 *  station's. */
struct ThreeLines {
  std::array<std::vector<Eigen::Vector3d>, 3> lines;

  std::size_t stations() const { return lines[0].size(); }
  /** On the arc through the three points of a station, at the share \p w of its angle from start to end. */
  Eigen::Vector3d position(std::size_t station, double w) const;
};

} // namespace pcl_spiral::test
