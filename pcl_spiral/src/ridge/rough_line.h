// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A smooth curve through a few places.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

namespace pcl_spiral {

/** Points of a curve through \p places, about \p step apart. If the places lie on a circle, so does the curve: at each place it has the
 *  direction of the circle through that place and its neighbours, and between two places it is the cubic of such an arc. Two places give
 *  a straight line. The first point of a \p closed curve is not repeated. */
Polyline throughPlaces(const Polyline& places, bool closed, double step);

} // namespace pcl_spiral
