// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Sections of a surface by planes, found foot by foot.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/surface/surface.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** The sections by planes across a line, as feet of the fitted surface at steps along it: foot 0 where the walk begins, positive to the
 *  left of the line's direction as seen from outside, negative to the right. */
struct ScanSections {
  int most = 0;                  ///< steps to either side
  double step = 0.0;             ///< mm
  std::vector<SurfaceFoot> feet; ///< of each section from -most to most; not valid beyond the end of the scan

  std::size_t size() const { return feet.size() / static_cast<std::size_t>(2 * most + 1); }
  const SurfaceFoot& foot(std::size_t section, int k) const { return feet[slot(section, k)]; }
  std::size_t slot(std::size_t section, int k) const
  {
    return section * static_cast<std::size_t>(2 * most + 1) + static_cast<std::size_t>(k + most);
  }
  /** Steps to where the scan ends; \p side -1 or 1. */
  int reach(std::size_t section, int side) const;
};

/** Walk from the points of the scan nearest to \p places, across \p tangents. */
ScanSections walkSections(const Surface& surface, const Polyline& places, const Polyline& tangents, double step, int most);

} // namespace pcl_spiral
