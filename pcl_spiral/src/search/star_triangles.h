/** \file
 *  The triangles that stars agree on. Private to search.
 */
#pragma once

#include "star_set.h"

#include <pcl_spiral/search/triangulation.h>

namespace pcl_spiral {

/** Triangles all three of whose corners have them in their stars; then, where half-edges are still free, those that two
 *  corners have and those that one has; then the pinholes left by disagreement, of at most \p pinhole_edges edges,
 *  closed. */
Triangulation
triangulate(const StarSet& stars, int pinhole_edges);

} // namespace pcl_spiral
