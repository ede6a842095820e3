// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The closed boundary loops of a cloud.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Ordered, closed boundary loops of a scanned surface: its rim, real holes, gaps in the data.
 *
 *  The free half-edges of local Delaunay stars are linked; see findBoundaryLoops. The published walk from boundary point to
 *  boundary point (Wu et al. 2025, section 1) fails at corners and gaps. It can be chosen too (setLoopMethod).
 *  The stars also give the boundary points. setBoundaryPoints replaces them, for example with those of
 *  CentroidBoundaryEstimation or pcl::BoundaryEstimation. Lengths in the unit of the cloud, mm.
 *  Takes a cloud or a surface, see SurfaceInput. Normals define the side from which loops run counter-clockwise.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class BoundaryLoops : public SurfaceInput<pcl::PCLBase<PointT>, PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<BoundaryLoops>;                              ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const BoundaryLoops>;                   ///< A shared pointer to a constant one.
  using BoundaryPointsConstPtr = pcl::PointCloud<pcl::Boundary>::ConstPtr; ///< Boundary flags, shared.

  /** Boundary flags, one per input point: those of CentroidBoundaryEstimation, of pcl::BoundaryEstimation, or
   *  the user's own. LoopMethod::HalfEdges leaves out loops with less than half of their points marked, and fails if the rim
   *  is such a loop. LoopMethod::Walk goes from marked point to marked point. Without flags, the boundary points are those
   *  with an open star. */
  void setBoundaryPoints(const BoundaryPointsConstPtr& points) { boundary_points_ = points; }
  BoundaryPointsConstPtr getBoundaryPoints() const { return boundary_points_; } ///< The value of setBoundaryPoints.

  /** How points are put in order; LoopMethod::HalfEdges by default. */
  void setLoopMethod(LoopMethod method) { options_.method = method; }
  LoopMethod getLoopMethod() const { return options_.method; } ///< The value of setLoopMethod.

  /** Largest change of direction of the walk from one step to the next, degrees, above 0 to 180; 90 by default. */
  void setMaxTurn(double degrees) { options_.max_turn = degrees; }
  double getMaxTurn() const { return options_.max_turn; } ///< The value of setMaxTurn.

  /** Least length of a real hole, mm; shorter loops are gaps in the data. 0, the default, decides by the length of the
   *  rim and the spacing, see BoundaryOptions. */
  void setMinHoleLength(double length) { options_.min_hole_length = length; }
  double getMinHoleLength() const { return options_.min_hole_length; } ///< The value of setMinHoleLength.

  /** Least width of a real hole, its largest extent, mm. If set, holes that are too narrow to stay open between triangles are
   *  found too. 0, the default: the length decides. */
  void setHoleSize(double width) { options_.min_hole_width = width; }
  /** \deprecated Renamed setHoleSize. */
  [[deprecated("use setHoleSize")]] void setMinHoleWidth(double width) { setHoleSize(width); }
  double getHoleSize() const { return options_.min_hole_width; } ///< The value of setHoleSize.

  /** Width, in spacings, up to which a hole is a gap in the data if no least length is set; 15 by default. */
  void setLargestGap(double spacings) { options_.largest_gap = spacings; }
  double getLargestGap() const { return options_.largest_gap; } ///< The value of setLargestGap.

  /** Radius of the largest circle without points that still counts as surface, in spacings; 3 by default. */
  void setAlpha(double spacings) { this->surfaceSettings().alpha = spacings; }
  double getAlpha() const { return this->surfaceSettings().alpha; } ///< The value of setAlpha.

  /** Called with the share done; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Find the loops, the rim first; indices refer to the cloud. \p loops is empty on failure. */
  void compute(std::vector<BoundaryLoop>& loops);

  /** What the last compute left out. */
  const BoundaryReport& getReport() const { return counts_; }
  [[deprecated("use getReport")]] const BoundaryReport& getCounts() const { return getReport(); } ///< \deprecated Use getReport.

private:
  Status run(std::vector<BoundaryLoop>& loops);

  BoundaryPointsConstPtr boundary_points_;
  BoundaryOptions options_;
  ProgressCallback progress_;
  BoundaryReport counts_;
};

} // namespace pcl_spiral

#include <pcl_spiral/features/impl/boundary_loops.hpp>

namespace pcl_spiral {
extern template class BoundaryLoops<pcl::PointXYZ>;
extern template class BoundaryLoops<pcl::PointXYZRGB>;
extern template class BoundaryLoops<pcl::PointNormal>;
} // namespace pcl_spiral
