// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The separate parts of the surface of a cloud.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Triangles connected by their edges. */
struct SurfacePart {
  std::size_t triangles = 0;
  double area = 0.0;                                ///< mm2
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< mean, weighted by area
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< its point nearest to the centre
  Eigen::AlignedBox3d box;                          ///< around its points
};

/** The parts of the surface of a graph, by decreasing number of triangles. */
struct SurfaceParts {
  std::vector<SurfacePart> parts;
  std::vector<std::uint32_t> of_triangle; ///< index into parts
};

SurfaceParts surfaceParts(const SurfaceGraph& graph);

/** What the parts other than the one with most triangles are. */
enum class OtherParts {
  None,
  Clusters, ///< clusters to be left out
  TooMany,  ///< clusters, but too many in all: the scan is disconnected
  TooLarge  ///< at least one is not a cluster
};

/** Largest share of all triangles in one cluster; ten times that for all clusters together. */
constexpr double largest_cluster = 0.02;

/** True if a part other than the \p first, with \p share of all triangles at most, is a cluster. A part that is much larger in
 *  area is not, because a coarse scan has few triangles beside a fine one. */
bool isCluster(const SurfacePart& part, const SurfacePart& first, std::size_t all_triangles, double share);

/** What the other parts are. \p parts by decreasing number of triangles; \p share: the largest of a cluster. */
OtherParts otherParts(const std::vector<SurfacePart>& parts, double share);

/** The part with a point nearest to \p place, and the distance of that point, mm. */
std::size_t nearestPart(const SurfaceGraph& graph, const SurfaceParts& parts, const Eigen::Vector3d& place, double& distance);

/** "7854 mm2 at (1, 2, 3), 12 mm2 at (4, 5, 6) and 7 more": \p parts as text with a point of each, the first few listed. The points are
 *  proposed for setPartAt if the user has \p to_choose a part. */
Diagnostic partsText(const std::vector<SurfacePart>& parts, bool to_choose = true);

/** Where a part is nearest to any other one. */
struct PartDistance {
  double distance = 0.0;                            ///< mm, between two points
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< of these two
};

/** Of part number \p part, which is not the only one. */
PartDistance nearestOther(const SurfaceGraph& graph, const SurfaceParts& parts, std::size_t part);

/** The refusal of several \p parts of which none was chosen. */
Diagnostic severalPartsText(const SurfaceGraph& graph, const SurfaceParts& parts);

/** For each point of the graph: 1 if it belongs only to parts other than number \p part. A point without a triangle
 *  does not. */
std::vector<std::uint8_t> apartFrom(const SurfaceGraph& graph, const SurfaceParts& parts, std::size_t part);

} // namespace pcl_spiral
