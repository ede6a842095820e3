// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far apart neighbouring rows of parallel planes may be if any cutter of revolution cuts a curved surface.
 */
#pragma once

#include "row_distance.h"
#include <pcl_spiral/core/cutter_profile.h>

namespace pcl_spiral {

/** As rowDistance, for any cutter. With RowsThrough::Centres the tool stands along \p axis and its tips are in the planes; with
 *  RowsThrough::Contacts it stands along the normals.
 *
 *  A straight pass over a plane touches it along the places of the cutter with normals across the travel. The contact of the next
 *  row is moved along these places away from the point between the rows, over the paraboloid of the surface, until the cutter
 *  leaves the height there. For rows of tips and small heights that is exact: with C the curvatures of the cutter at the contact,
 *  S those of the surface and w across the travel, the contact moves along C^-1 w whatever S is, and the distance is
 *  2 sqrt(2 h (w'C^-1 w + (C^-1 w)'S C^-1 w)) times the share of w across the planes. On planes it is exact for any height.
 *
 *  Where a cutter with a flat end stands on its edges in a hollow, rows are those of a ball with its corner radius. Curvatures less
 *  concave than \p flattest, 1/mm, count as 0: a scan shows them by its noise. Infinite where the cutter does not reach. */
double profileRowDistance(const SurfaceBend& place, const Eigen::Vector3d& across, const CutterProfile& profile,
                          const Eigen::Vector3d& axis, double height, RowsThrough through, double flattest);

} // namespace pcl_spiral
