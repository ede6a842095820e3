// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Rail and generator of a ridge from a full scan.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/ridge/impl/ridge_lines_engine.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <utility>

namespace pcl_spiral {

/** Finds the two lines of a ridge from a scan of the whole part and a few rough points
 *  of the ridge. Also reports how well the surface that they sweep fits the part.
 *  \code
 *  RidgeLines<pcl::PointXYZ> lines;
 *  lines.setInputCloud(scan);
 *  lines.setRoughPoints({begin, between, end}); // some mm off the ridge will do
 *  lines.setHalfWidth(12.0);                    // mm, to either side
 *  lines.compute(*rail, *generator);
 *  if (!lines.getStatus().ok()) ...             // names place, value and remedy
 *  if (lines.getReport().misfit > ...) ...      // is the part a ridge in this sense?
 *  \endcode
 *  Rail and generator go to RidgeToolpath::setInputCloud and setInputGenerator. Takes a cloud or a surface, see SurfaceInput. The
 *  normals point to the side of the tool; ridges are convex on that side. If a ridge is a hollow on that side, use setFlipNormals.
 *  Lengths in mm. The output does not depend on the order of the cloud or on the number of threads. \sa findScanRidge */
template <typename PointT>
class RidgeLines : public SurfaceInput<pcl::PCLBase<PointT>, PointT> {
public:
  using Ptr = pcl::shared_ptr<RidgeLines>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const RidgeLines>; ///< A shared pointer to a constant one.
  using Cloud = pcl::PointCloud<PointT>;              ///< Points of one line.

  /** Two or more places on the ridge in their order along it: at its wanted ends and, where it bends, between. For a closed ridge:
   *  three or more, all round it. The crest is looked for within the half width of a smooth curve through them. Must be set. */
  void setRoughPoints(Polyline points) { settings_.rough_points = std::move(points); }
  const Polyline& getRoughPoints() const { return settings_.rough_points; } ///< The value of setRoughPoints.
  /** Whether the ridge is a ring; false by default. */
  void setClosed(bool closed) { settings_.closed = closed; }
  bool getClosed() const { return settings_.closed; } ///< The value of setClosed.
  /** How far the generator extends to either side of the crest, along the surface, mm.
   *  It is shorter where the scan ends before; a warning reports this. Must be set. */
  void setHalfWidth(double width) { settings_.half_width = width; }
  double getHalfWidth() const { return settings_.half_width; } ///< The value of setHalfWidth.

  /** Normal of the reference plane: the chord of the generator keeps its angle with it; (0, 0, 1) by
   *  default. For a vertical ridge, take a normal across the ridge. Set the same in RidgeToolpath. */
  void setReferenceNormal(const Eigen::Vector3d& normal) { settings_.reference = normal; }
  const Eigen::Vector3d& getReferenceNormal() const { return settings_.reference; } ///< The value of setReferenceNormal.

  /** Distance between the points of both lines, mm; 0, the default: twice that of the scan's points. */
  void setPointSpacing(double spacing) { settings_.point_spacing = spacing; }
  double getPointSpacing() const { return settings_.point_spacing; } ///< The value of setPointSpacing.
  /** Largest number of rounds that align the sections; 30 by default. */
  void setMaximumIterations(int rounds) { settings_.most_rounds = rounds; }
  int getMaximumIterations() const { return settings_.most_rounds; } ///< The value of setMaximumIterations.
  /** Called with the completed share; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Computes the points of both lines; empty on failure. */
  void compute(Cloud& rail, Cloud& generator);

  /** The same lines in double precision, for RidgeSurface::make; empty on failure. */
  const Polyline& getRail() const { return found_.rail; }
  const Polyline& getGenerator() const { return found_.generator; } ///< As getRail, of the generator.
  /** The ridge that they make; up is the side of the scan's normals; null on
   *  failure. Give its settings().flip to RidgeToolpath::setFlipNormals. */
  RidgeSurface::ConstPtr getRidge() const { return found_.ridge; }
  /** Misfit, noise, rounds, warnings of the last compute. */
  const ScanRidgeReport& getReport() const { return found_.report; }

private:
  Status run();

  ScanRidgeSettings settings_;
  ScanRidge found_;
  ProgressCallback progress_;
};

} // namespace pcl_spiral

#include <pcl_spiral/ridge/impl/ridge_lines.hpp>

namespace pcl_spiral {
extern template class RidgeLines<pcl::PointXYZ>;
extern template class RidgeLines<pcl::PointXYZRGB>;
extern template class RidgeLines<pcl::PointNormal>;
} // namespace pcl_spiral
