/** \file
 *  The separate parts a cloud's surface falls into.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Triangles that hang together by their edges. */
struct SurfacePart {
  std::size_t triangles = 0;
  double area = 0.0; ///< mm2
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< mean by area
};

/** The parts of a graph's surface, by falling number of triangles. */
struct SurfaceParts {
  std::vector<SurfacePart> parts;
  std::vector<std::uint32_t> of_triangle; ///< entry of parts
};

SurfaceParts
surfaceParts(const SurfaceGraph& graph);

/** What the parts beside the one of most triangles are. */
enum class OtherParts {
  None,
  Specks,   ///< to be left out
  TooMany,  ///< specks, but too much in all: the scan does not hang together
  TooLarge  ///< at least one is no speck
};

/** Share of all triangles that a speck has at most; ten times that, all of them together. */
constexpr double largest_speck = 0.02;

/** Whether a part beside the \p first, of \p share of all triangles at most, is a speck: what is much larger in area is
 *  none, for a coarse scan has few triangles beside a fine one. */
bool
isSpeck(const SurfacePart& part, const SurfacePart& first, std::size_t all_triangles, double share);

/** \p parts by falling number of triangles, \p share the largest of a speck. */
OtherParts
otherParts(const std::vector<SurfacePart>& parts, double share);

/** "7854 mm2 about (1, 2, 3), 12 mm2 about (4, 5, 6) and 7 more": \p parts, the first few by name. */
std::string
partsText(const std::vector<SurfacePart>& parts);

/** For each point of the graph, whether it belongs to other parts than number \p part alone; a point of no triangle does
 *  not. */
std::vector<std::uint8_t>
apartFrom(const SurfaceGraph& graph, const SurfaceParts& parts, std::size_t part);

} // namespace pcl_spiral
