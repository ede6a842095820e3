// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Places without points that the triangles of a surface cover.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** One such place: a hole of the part too narrow to be an open loop, or a gap in the data. mm. */
struct ScanVoid {
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< its middle
  double width = 0.0;                              ///< its largest extent
  std::vector<std::uint32_t> triangles;            ///< that cover it, ascending
};

/** The voids of a surface.
 *
 *  An open loop needs empty circles of three spacings (SurfaceGraphOptions::max_circumradius). Large triangles cover narrower
 *  holes. Among n random points, each with a share a of the surface, a given area A is empty with the
 *  probability exp(-A / a). So triangles with a wide empty circle are joined into clusters. A cluster away from the boundary
 *  counts as a void if the largest of the circles, or the triangles together, cover A > (ln n + 9) a.
 *  Chance produces one in about one scan of fifty. */
class ScanVoids {
public:
  ScanVoids() = default;
  explicit ScanVoids(const SurfaceGraph& graph);

  /** The voids, in the order of their triangles. */
  const std::vector<ScanVoid>& voids() const { return voids_; }
  /** True if \p place lies in a void; \p nearest is the point nearest to it. */
  bool contains(const Eigen::Vector3d& place, std::uint32_t nearest) const;

private:
  struct Disc {
    Eigen::Vector3d centre;
    double radius;
  };
  struct Near {
    std::uint32_t point, disc;
  };
  void addDiscs(const SurfaceGraph& graph, const ScanVoid& found);

  std::vector<ScanVoid> voids_;
  std::vector<Disc> discs_; ///< empty circles of the triangles in voids
  std::vector<Near> near_;  ///< discs near each point, by point
};

} // namespace pcl_spiral
