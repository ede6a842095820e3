// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A smooth curve through a few places.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

namespace pcl_spiral {

/** Points of a curve through \p places, about \p step apart, that is a circle where they lie on one: at each place it runs along the circle
 *  through that and its neighbours, between two it is the cubic of such an arc. Two places give a straight line. Of a \p closed
 *  curve the first point does not come again. */
Polyline throughPlaces(const Polyline& places, bool closed, double step);

} // namespace pcl_spiral
