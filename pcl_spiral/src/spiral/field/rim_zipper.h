// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Triangles between the ragged edge of a triangulation and the outline fitted to it.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/graph/impl/triangulation.h>

#include <vector>

namespace pcl_spiral {

/** One side of the strip to fill: a closed run of points with the arc length along the outline at each. */
struct ZipperSide {
  std::vector<std::uint32_t> ids;
  Polyline points;
  std::vector<double> arcs;             ///< mm; of the outline's points ascending
  std::vector<Eigen::Vector3d> normals; ///< of the edge's points; not used for the outline's
};

/** The cheapest closed strip of triangles between \p edge (free half-edges, surface on their left) and \p outline, of
 *  \p length: the least sum of the lengths of new edges, plus ten spacings for each triangle that faces down. Arc lengths of the two
 *  ends of an edge differ by at most twelve spacings. Dynamic programming within that band, in near-linear time. Empty if there is
 *  none. */
std::vector<Triangulation::Triangle> zipped(const ZipperSide& edge, const ZipperSide& outline, double length, double spacing);

/** The points of each side that are farther than four spacings from the other. */
Polyline pointsApart(const ZipperSide& edge, const ZipperSide& outline, double spacing);

} // namespace pcl_spiral
