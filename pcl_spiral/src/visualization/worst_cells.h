// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A map that shows the worst value of each place.
 */
#pragma once

#include "sheet.h"

#include <functional>
#include <vector>

namespace pcl_spiral {

/** Values on a view, in cells of two pixels: each cell keeps the value of the highest rank. */
class WorstCells {
public:
  /** \p width and \p height of the view, pixels. */
  WorstCells(int width, int height);

  /** Puts a value on the cell at \p place and on cells with their middle within \p radius; pixels from the
   * lower left corner. Ranks count from 0; of equal ranks the first value stays. */
  void put(const Eigen::Vector2d& place, double radius, float value, float rank);

  /** Draws over everything in \p view. */
  void addTo(vtkRenderer* view, const std::function<Color(float)>& color) const;

private:
  int columns_, rows_;
  std::vector<float> values_, ranks_; ///< rank -1: empty
};

} // namespace pcl_spiral
