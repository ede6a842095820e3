// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the drawn surface hides.
 */
#pragma once

#include "canvas.h"

#include <vector>

namespace pcl_spiral {

/** How near to the viewer the surface comes at each place of a canvas, in cells of two pixels. */
class DepthMap {
public:
  DepthMap(const DisplaySurface& surface, const Canvas& canvas);

  /** Whether the surface lies before \p place, by more than the drawn surface may be off. */
  bool hides(const Eigen::Vector3d& place) const;

private:
  void addTriangle(const std::array<Eigen::Vector3d, 3>& corners);

  const Canvas& canvas_;
  double clearance_;
  std::vector<float> depth_; ///< towards the viewer, mm
};

} // namespace pcl_spiral
