// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The true outline behind the jagged run of outermost points. Private to features.
 */
#pragma once

#include "loop_rings.h"

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl_spiral {

/** A closed curve on the surface, evenly spaced between its corners. */
struct Outline {
  Polyline curve;
  std::vector<std::size_t> corners; ///< entries of curve
};

/** Outline of \p ring. \p goOn is called between the fits; if it returns false, the result must not be used. */
Outline fitOutline(const MlsSurface& surface, const Ring& ring, const std::function<bool()>& goOn);

} // namespace pcl_spiral
