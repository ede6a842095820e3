// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Stock as rays along the normals of an exact surface, cut by a tool of revolution. Lengths in mm.
 */
#pragma once

#include "support/machine_oracle.h"
#include "support/surfaces.h"

#include <cstddef>
#include <vector>

namespace pcl_spiral::test {

/** A ball (corner = radius) or a bull-nose, \p length long from its tip: all places within the corner radius of the
 *  cylinder inside it. */
struct RoundedCutter {
  double radius, corner, length;

  /** Distance of \p q to the tool at \p place; not above 0 inside. */
  double distance(const TipAndAxis& place, const Eigen::Vector3d& q) const;
};

/** What is left over the rays that are farther than a band from the outline. */
struct CutReport {
  std::size_t rays = 0;
  double gouge = 0.0; ///< deepest cut below the surface, of all rays, those of the band too
  double most = 0.0;  ///< highest stock, as far as the rays reach
  double high = 0.0;  ///< 98 % of the rays have no more
};

/** Rays over a surface given as heights over x and y. */
class CutRays {
public:
  /** Rays about \p spacing apart, from \p deepest below the surface to \p reach above it. */
  CutRays(const AnalyticSurface& surface, double spacing, double deepest, double reach);

  /** Takes away what the tool fills at a place. */
  void cut(const RoundedCutter& cutter, const TipAndAxis& place);

  CutReport figures(double band) const;

private:
  struct Ray {
    Eigen::Vector3d x, normal;
    double stock, rim;
  };

  void cutRay(const RoundedCutter& cutter, const TipAndAxis& place, Ray& ray) const;
  int columnOf(double x) const;
  int rowOf(double y) const;

  static constexpr double cell = 1.0;
  double deepest_;
  Eigen::Vector2d lower_;
  int columns_, rows_;
  std::vector<std::vector<Ray>> cells_;
};

} // namespace pcl_spiral::test
