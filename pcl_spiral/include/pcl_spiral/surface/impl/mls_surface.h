// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Moving-least-squares surface of a cloud: feet, normals and curvatures of any points.
 */
#pragma once

#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The foot of a point on the surface, and the shape of the surface there. Curvatures are positive where the surface is
 *  convex (curves away from its normal). */
struct SurfaceFoot {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();     ///< unit, out of the material
  Eigen::Vector3d direction1 = Eigen::Vector3d::UnitX(); ///< unit, principal direction of curvature1
  double curvature1 = 0.0;                               ///< the larger principal curvature, 1/mm
  double curvature2 = 0.0;                               ///< the smaller, across direction1
  double residual = 0.0;                                 ///< standard deviation of the cloud about the fit here, mm
  double overhang = 0.0;                                 ///< distance beyond the outermost points of the cloud, mm; 0 inside
  double nearest_distance = 0.0;                         ///< from the nearest point of the cloud, mm
  std::uint32_t nearest = 0;                             ///< index of that point, in the order of the graph
  bool valid = false;                                    ///< false far from the cloud, beyond its rim, or where the fit is not determined

  /** Normal curvature in the tangent direction \p t (unit), by Euler's theorem. */
  double normalCurvature(const Eigen::Vector3d& t) const
  {
    const double c = t.dot(direction1), s = t.dot(normal.cross(direction1));
    const double whole = c * c + s * s;
    return whole > 0.0 ? (curvature1 * c * c + curvature2 * s * s) / whole : 0.5 * (curvature1 + curvature2);
  }
  double gaussCurvature() const { return curvature1 * curvature2; }
};

/** Type of the fitted surface. */
enum class ProjectionMethod {
  Quadratic,          ///< local quadric with a compact C2 weight, iterated
  RobustQuartic,      ///< fourth degree where the noise is low enough to tell it from the quadric, without outliers;
                      ///< used to check a path
  DirectionalCentroid ///< as published (Wu et al. 2025, equations 8-11): order zero, biased by (k1 + k2) h^2 / 4
};

/** Projects points onto the surface of a graph. Cheap to construct; the graph must outlive it. */
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

  const SurfaceGraph& graph_;
  ProjectionMethod method_;
  int neighbours_;
  double noise_ = 0.0;
};

} // namespace pcl_spiral
