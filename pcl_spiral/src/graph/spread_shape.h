// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How the nearest neighbours of a point are spread. Private.
 */
#pragma once

#include "search/neighbour_search.h"

namespace pcl_spiral {

/** The spread of one neighbourhood of \p neighbours points. */
struct SpreadShape {
  static constexpr int neighbours = 32;

  float spacing;   ///< as if they were spread evenly
  float fine;      ///< the same, of the nearest half of them
  float near;      ///< distance of the 8th nearest
  float line_step; ///< distance between neighbours along a line, if the nearest few lie on one; otherwise 0
  bool is_double;  ///< another point lies nearly at the same place
  bool is_off;     ///< the neighbours lie in no plane, or the point lies off their plane
};

SpreadShape spreadShape(const Neighbourhood& near);

} // namespace pcl_spiral
