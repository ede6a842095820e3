// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The normal of a surface fitted about a vertex. Private to mesh.
 */
#pragma once

#include "corner_sectors.h"

#include <Eigen/Core>

namespace pcl_spiral {

/** Fits cubic surfaces, one sector after the other. */
class NormalFit {
public:
  NormalFit(const Triangulation& mesh, const std::vector<Eigen::Vector3d>& positions, const CornerSectors& sectors);

  /** Replace \p normal, of the faces, by that of the cubic surface fitted to two rings about \p sector's vertex, not across
   *  creases. False, with \p normal unchanged, if these do not determine one, or it leans far off. \p noise, if given:
   *  standard deviation of the vertices about the fit, mm. */
  bool refine(std::uint32_t sector, Eigen::Vector3d& normal, double* noise = nullptr);

private:
  bool fit(Eigen::Vector3d& normal, double* noise) const;
  void takeFan(std::uint32_t sector);
  void takeRing();

  const Triangulation& mesh_;
  const std::vector<Eigen::Vector3d>& positions_;
  const CornerSectors& sectors_;
  std::vector<std::uint32_t> vertex_seen_, sector_seen_; ///< the last round that took it
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> vertices_;         ///< the sector's own first
  Eigen::Vector3d mean_normal_;                 ///< of the rings' faces, by areas
  std::vector<std::uint32_t> fans_, next_fans_; ///< sectors about the vertices of the outermost ring
};

} // namespace pcl_spiral
