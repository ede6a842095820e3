// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Moving-least-squares surface of a cloud: feet, normals and curvatures of any points.
 */
#pragma once

#include <pcl_spiral/fit/surface_foot.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Projects points onto the surface of a graph, whose data it shares. Cheap to construct and to copy. */
class MlsSurface {
public:
  /** \p neighbours in one fit; 0: as many as the noise needs and the curvature allows, and enough to span several scan
   *  lines: from max(32, graph.neighbours()), half as many again for RobustQuartic, doubled up to 256. */
  explicit MlsSurface(const SurfaceGraph& graph, int neighbours = 0, ProjectionMethod method = ProjectionMethod::Quadratic);

  /** Feet of all queries, in their order, in parallel. Queries that are not finite or farther than four spacings from
   *  the cloud become invalid. For an invalid foot, fits with twice the neighbours are tried, and so on up to \p widest times as
   *  many, up to eight spacings from a point: beside a gap, all nearest points may lie on its denser side. Use this only for
   *  queries that are known to lie within the rim. Beyond the rim a wide fit may reach outliers. */
  void project(const std::vector<Eigen::Vector3d>& queries, std::vector<SurfaceFoot>& feet, int widest = 1) const;
  SurfaceFoot project(const Eigen::Vector3d& query) const;

  /** The same fit, whose graph has no triangles. */
  MlsSurface withoutTriangulation() const;

  int neighbours() const { return neighbours_; }
  /** Standard deviation of the points about the surface, mm (for a cloud without noise: the residual of the fit). */
  double noise() const { return noise_; }
  /** Standard deviation of the surface itself, inside the rim, mm: noise() sqrt(f / k) for k evenly spread neighbours.
   *  f follows from the weights. Quadratic: (1 - r^2)^3 and second degree, 50 / 7. RobustQuartic: 9.46 where noise hides
   *  what the fourth degree adds. The variance of the quartic is 14.10 / k. The fit takes its difference to the quadric in
   *  proportion to its significance, and a third remains. DirectionalCentroid: exp(-4 r^2) and order zero, 2.08. */
  double fitNoise() const;
  const SurfaceGraph& graph() const { return graph_; }

private:
  void chooseNeighbours();
  /** Move the feet of \p which by one fit about their present places. Returns which feet moved so far that they
   *  need another fit. */
  std::vector<std::uint8_t> projectOnce(const std::vector<std::uint32_t>& which, std::vector<SurfaceFoot>& feet, int neighbours) const;

  SurfaceGraph graph_;
  ProjectionMethod method_;
  int neighbours_;
  double noise_ = 0.0;
};

} // namespace pcl_spiral
