/** \file
 *  A scan as cutters are located on it: obstacles, surface, rim.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/surface/clean_graph.h>
#include <pcl_spiral/surface/mls_surface.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace pcl_spiral {

/** All points, which cutters must stay off; the surface through those that form one; and its rim. Lengths in
 * mm. */
class LocationSurface {
public:
  LocationSurface() = default;
  LocationSurface(const LocationSurface&) = delete; // the fits refer to the graph
  LocationSurface& operator=(const LocationSurface&) = delete;

  /** Make it of finite, different \p points. Where they form no surface, hasSurface() is false and whyNone()
   * says why. */
  void build(std::vector<Eigen::Vector3f> points);

  /** Every point, those off the surface too. */
  const PointBlocks&
  obstacles() const
  {
    return obstacles_;
  }
  bool
  hasSurface() const
  {
    return surface_ != nullptr;
  }
  const Status&
  whyNone() const
  {
    return surface_status_;
  }
  const MlsSurface&
  surface() const
  {
    return *surface_;
  }
  /** Points left out of the surface, not of the obstacles: alone off it. */
  std::size_t
  strayPoints() const
  {
    return source_.strays.size();
  }
  /** Corners of the triangulation's edges that have a triangle on one side only, along loops longer than
   * eight spacings: beyond them, or in the gap they bound, nothing is known. */
  const PointBlocks&
  rim() const
  {
    return rim_;
  }

  /** How far single points may stand above the surface fitted to them, measured along its normal: five
   * standard deviations of their noise, and the rounding of coordinates. A point higher than that is no
   * noise. */
  double
  noiseAllowance() const
  {
    return noise_allowance_;
  }
  /** Which of the points given to build is point \p i of the surface's graph. */
  std::uint32_t
  source(std::uint32_t i) const
  {
    return source_.indices[graph_.blocks().originalIndex(i)];
  }
  /** Whether a foot lies among the points, not over a gap between them. */
  bool
  covers(const SurfaceFoot& foot) const
  {
    return foot.valid && foot.nearest_distance <= 1.5 * coveringRadius(foot.nearest);
  }
  /** About point \p i of the surface's graph: largest circumradius of the triangles of its own and of its
   * neighbours. No place of the surface near there is farther from the nearest point. */
  double
  coveringRadius(std::uint32_t i) const
  {
    return covering_radius_[i];
  }

private:
  void findRim();
  void findCoveringRadii();

  PointBlocks obstacles_, rim_;
  SurfaceGraph graph_;
  GraphSource source_;
  Status surface_status_;
  std::unique_ptr<MlsSurface> surface_;
  std::vector<float> covering_radius_;
  double noise_allowance_ = 0.0;
};

} // namespace pcl_spiral
