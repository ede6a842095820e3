// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Finds what the drawn surface hides.
 */
#pragma once

#include "canvas.h"

#include <vector>

namespace pcl_spiral {

/** Depth of the surface, towards the viewer, at each place of a canvas, in cells of two pixels. */
class DepthMap {
public:
  DepthMap(const DisplaySurface& surface, const Canvas& canvas);

  /** Whether the surface is in front of \p place, by more than the error of the drawn surface. */
  bool hides(const Eigen::Vector3d& place) const;

private:
  void addTriangle(const std::array<Eigen::Vector3d, 3>& corners);

  const Canvas& canvas_;
  double clearance_;
  std::vector<float> depth_; ///< towards the viewer, mm
};

} // namespace pcl_spiral
