// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A scan prepared for locating cutters on it: obstacles, surface, rim.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/surface/surface.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace pcl_spiral {

/** All points, which cutters must stay off; the surface through
 *  those points that form one; and its rim. Lengths in mm. */
class LocationSurface {
public:
  /** Obstacles are finite and distinct \p points. \p surface is made of them, or null if they form none; \p why_none
   *  then gives the reason. \p source is the index of each point in its cloud; empty: all of the cloud, in order. */
  LocationSurface(std::vector<Eigen::Vector3f> points, std::vector<std::uint32_t> source, Surface::ConstPtr surface, Status why_none);
  /** Obstacles are the points of \p surface and those that were left out of it. */
  explicit LocationSurface(const Surface::ConstPtr& surface);
  LocationSurface(const LocationSurface&) = delete; // shared
  LocationSurface& operator=(const LocationSurface&) = delete;

  /** Every point, also those off the surface. */
  const PointBlocks& obstacles() const { return obstacles_; }
  bool hasSurface() const { return surface_ != nullptr; }
  const Status& whyNone() const { return surface_status_; }
  const MlsSurface& surface() const { return surface_->fit(); }
  /** Outliers: points left out of the surface, but still obstacles. */
  std::size_t outlierPoints() const { return surface_->report().offSurface(); }
  /** Corners of the triangulation's edges that have a triangle on one side only, along loops
   *  longer than eight spacings. Beyond them, or in the gap they bound, nothing is known. */
  const PointBlocks& rim() const { return rim_; }

  /** The edge of the surface, continued straight by half a spacing beyond its outlines, not into gaps in the data: places a quarter
   *  of a spacing apart and closer. A cutter that would touch farther out rests on it. Empty if no outlines are found. */
  const PointBlocks& edge() const { return edge_; }
  /** How far a place next to the outlines lies beyond the nearest of them, mm; negative inside. Minus infinity without outlines. */
  double beyondOutline(const Eigen::Vector3d& place) const;

  /** The points of the surface without their noise: their places on the fit. Found on the first call. */
  const PointBlocks& feet() const;

  /** How far single points may stand above the surface fitted to them,
   *  measured along its normal: five standard deviations of their noise, plus
   *  the rounding of coordinates. A point higher than that is not noise. */
  double noiseAllowance() const { return noise_allowance_; }
  /** Index in the cloud of point \p i of the surface. */
  std::uint32_t cloudIndexOnSurface(std::uint32_t i) const { return surface_->sourceIndex(i); }
  /** Index in the cloud of obstacle \p i, by its original index among obstacles(). */
  std::uint32_t cloudIndex(std::uint32_t i) const { return source_.empty() ? i : source_[i]; }
  /** Whether a foot lies among the points, and not over a gap between them. */
  bool covers(const SurfaceFoot& foot) const { return foot.valid && foot.nearest_distance <= 1.5 * coveringRadius(foot.nearest); }
  /** Near point \p i of the surface's graph: largest circumradius of its own triangles and of those
   *  of its neighbours. No place of the surface near there is farther from the nearest point. */
  double coveringRadius(std::uint32_t i) const { return covering_radius_[i]; }

private:
  void measure();
  void findEdge();
  void findRim();
  void findCoveringRadii();

  PointBlocks obstacles_, rim_;
  PointBlocks edge_;
  std::vector<Eigen::Vector3f> outward_; ///< at each place of the edge, unit
  std::vector<float> out_;               ///< of each place of the edge: mm beyond the outline
  mutable PointBlocks feet_;
  mutable std::once_flag feet_once_;
  std::vector<std::uint32_t> source_;
  Surface::ConstPtr surface_;
  Status surface_status_;
  std::vector<float> covering_radius_;
  double noise_allowance_ = 0.0;
};

} // namespace pcl_spiral
