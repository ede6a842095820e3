// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  On which side of the outlines of a surface a point lies.
 */
#pragma once

#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/search/impl/move_index.h>

#include <memory>
#include <vector>

namespace pcl_spiral {

/** The place on the outlines nearest to a point. */
struct OutlinePlace {
  double distance = 0.0; ///< mm
  bool inside = true;    ///< on the side of the surface
  std::size_t outline = 0;
  double arc = 0.0; ///< along that outline, mm
};

/** Searches the fitted outlines of a surface. */
class OutlineSide {
public:
  explicit OutlineSide(const std::vector<BoundaryLoop>& outlines);

  /** Where the point \p p of the surface, with the unit \p normal there, lies beside the nearest outline; false if that is
   *  farther than \p within. At a corner both of its sides count. */
  bool find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double within, OutlinePlace& place) const;

private:
  Eigen::Vector3d tangentBefore(std::size_t vertex) const;
  Eigen::Vector3d tangentAfter(std::size_t vertex) const;

  Polyline line_;
  std::vector<double> arcs_;              ///< of each vertex of line_ along its outline
  std::vector<std::uint32_t> outline_of_; ///< of each vertex
  std::vector<std::size_t> begin_;        ///< first vertex of each outline, and the end
  std::unique_ptr<MoveIndex> index_;
};

} // namespace pcl_spiral
