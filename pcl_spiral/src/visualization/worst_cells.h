// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A map in which the worst value of each place is seen.
 */
#pragma once

#include "sheet.h"

#include <functional>
#include <vector>

namespace pcl_spiral {

/** Values on a view, in cells of two pixels: of those put on one cell, that of the highest rank stays. */
class WorstCells {
public:
  /** \p width and \p height of the view, pixels. */
  WorstCells(int width, int height);

  /** Put a value on the cell at \p place and those whose middles lie within \p radius of it; pixels from the
   * lower left corner. A rank counts from 0; of equal ones the first stays. */
  void put(const Eigen::Vector2d& place, double radius, float value, float rank);

  /** Draw over everything in \p view. */
  void addTo(vtkRenderer* view, const std::function<Color(float)>& color) const;

private:
  int columns_, rows_;
  std::vector<float> values_, ranks_; ///< rank -1: empty
};

} // namespace pcl_spiral
