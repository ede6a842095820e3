/** \file
 *  The closed boundaries of a cloud.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/features/impl/surface_boundary.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Ordered, closed boundary loops of a scanned surface: its outer rim, real holes, gaps in the data.
 *
 *  Instead of walking from boundary point to boundary point (Wu et al. 2025, section 1), which fails at corners and
 *  gaps, the free half-edges of local Delaunay stars are linked; see findBoundaryLoops. The walk is there to be chosen.
 *  Which points are of the boundary is found from the stars too, or given by setBoundaryPoints, as
 *  CentroidBoundaryEstimation and pcl::BoundaryEstimation tell it. Lengths in the cloud's unit, mm.
 *  Takes a cloud or a surface, see SurfaceInput. Normals say from which side loops run counter-clockwise.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class BoundaryLoops : public SurfaceInput<pcl::PCLBase<PointT>, PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<BoundaryLoops>;
  using ConstPtr = pcl::shared_ptr<const BoundaryLoops>;
  using BoundaryPointsConstPtr = pcl::PointCloud<pcl::Boundary>::ConstPtr;

  /** Which points are of the boundary, a flag a point of the input: those of CentroidBoundaryEstimation, of
   *  pcl::BoundaryEstimation, or the user's own. Linking half-edges, loops of which less than half the points are marked
   *  are left out, and the outer loop must not be; the walk goes from marked point to marked point. Without them, the
   *  points at which a star is open. */
  void setBoundaryPoints(const BoundaryPointsConstPtr& points) { boundary_points_ = points; }
  BoundaryPointsConstPtr getBoundaryPoints() const { return boundary_points_; }

  /** How points are put in order; LoopMethod::HalfEdges by default. */
  void setLoopMethod(LoopMethod method) { options_.method = method; }
  LoopMethod getLoopMethod() const { return options_.method; }

  /** Largest turn the walk takes from one step to the next, degrees, above 0 to 180; 90 by default. */
  void setMaxTurn(double degrees) { options_.max_turn = degrees; }
  double getMaxTurn() const { return options_.max_turn; }

  /** Shortest loop that is a real hole rather than a gap in the data, mm; 0, the default, decides by the length of the
   *  outer loop and the spacing, see BoundaryOptions. */
  void setMinHoleLength(double length) { options_.min_hole_length = length; }
  double getMinHoleLength() const { return options_.min_hole_length; }

  /** Least width of a real hole, its largest extent, mm; with it holes too narrow for the triangles to leave open are found too.
   *  0, the default: decided by the length. */
  void setMinHoleWidth(double width) { options_.min_hole_width = width; }
  double getMinHoleWidth() const { return options_.min_hole_width; }

  /** Size across, in spacings, up to which a hole is a gap in the data when no shortest hole is set; 15 by default. */
  void setLargestGap(double spacings) { options_.largest_gap = spacings; }
  double getLargestGap() const { return options_.largest_gap; }

  /** Largest circle free of points that still counts as surface: its radius in spacings; 3 by default. */
  void setAlpha(double spacings) { this->scanned_.setAlpha(spacings); }
  double getAlpha() const { return this->scanned_.getAlpha(); }

  /** Called with the share done; returning false cancels. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Find the loops, the outer one first; indices are those of the cloud. \p loops is empty on failure. */
  void compute(std::vector<BoundaryLoop>& loops);

  /** What the last compute left out. */
  const BoundaryCounts& getCounts() const { return counts_; }

private:
  Status run(std::vector<BoundaryLoop>& loops);

  BoundaryPointsConstPtr boundary_points_;
  BoundaryOptions options_;
  ProgressCallback progress_;
  BoundaryCounts counts_;
};

} // namespace pcl_spiral

#include <pcl_spiral/features/impl/boundary_loops.hpp>

namespace pcl_spiral {
extern template class BoundaryLoops<pcl::PointXYZ>;
extern template class BoundaryLoops<pcl::PointXYZRGB>;
extern template class BoundaryLoops<pcl::PointNormal>;
} // namespace pcl_spiral
