// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Radial lines of a scanned surface, from a cloud.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/radial_lines_engine.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** Curves over a surface from its centre, or its inner loop, to the rim, in order along the rim: the spiral is
 *  drawn on them. They are cubic B-splines that never cross, with one on every corner of the rim; see buildRadialLines.
 *
 *  Lines are geodesics, or gradient lines of a harmonic function where geodesics merge or leave the surface. This class does
 *  not bridge gaps (ScanGap loops), and geodesics do not cross them: use GapBridging before.
 *  Source: Wu, Chai, Bo, Liu, Wang, China Mechanical Engineering 36(4), 2025, 697-702, section 1. Millimetres.
 *  Takes a cloud or a surface, see SurfaceInput. Lines run counter-clockwise along the rim, seen from the side the normals face.
 *  The output does not depend on the order of the cloud or on the number of threads.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class RadialLines : public SurfaceInput<pcl::PCLBase<PointT>, PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<RadialLines>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const RadialLines>; ///< A shared pointer to a constant one.

  /** The boundaries, as BoundaryLoops or findBoundaryLoops gives them: the surface lies on the left of each. Without
   *  them, or with an empty vector, they are found. */
  void setBoundaryLoops(const std::vector<BoundaryLoop>& loops) { given_loops_ = loops; }
  const std::vector<BoundaryLoop>& getBoundaryLoops() const { return given_loops_; } ///< The value of setBoundaryLoops.
  /** The former name. */
  [[deprecated("setBoundaryLoops")]] void setLoops(const std::vector<BoundaryLoop>& loops) { setBoundaryLoops(loops); }

  /** Where lines start on a surface with one boundary: within three spacings of it. Without it, a balanced centre is found, which
   *  makes few turns and stays away from the rim (balancedCentre). */
  void setCenter(const Eigen::Vector3d& center) { center_ = center; }
  void clearCenter() { center_.reset(); } ///< Takes back setCenter.

  /** The first line ends at the rim point nearest to this point. Without it, at the corner, or without corners the rim point,
   *  farthest from the centre. */
  void setStartPoint(const Eigen::Vector3d& point) { start_point_ = point; }
  const std::optional<Eigen::Vector3d>& getStartPoint() const { return start_point_; } ///< The value of setStartPoint.
  void clearStartPoint() { start_point_.reset(); }                                     ///< Takes back setStartPoint.

  /** How lines are found; Automatic by default. */
  void setLineMethod(LineMethod method) { method_ = method; }
  LineMethod getLineMethod() const { return method_; } ///< The value of setLineMethod.

  /** One or two boundaries; Automatic by default. */
  void setBoundaryMode(BoundaryMode mode) { mode_ = mode; }
  BoundaryMode getBoundaryMode() const { return mode_; } ///< The value of setBoundaryMode.

  /** Allowed error of a turn interpolated between lines, mm; 0.05 by default. A smaller one makes more lines. */
  void setTolerance(double tolerance) { tolerance_ = tolerance; }
  double getTolerance() const { return tolerance_; } ///< The value of setTolerance.

  /** Allowed distance of a line's B-spline from its points, mm; 0.001 by default. */
  void setFitTolerance(double tolerance) { fit_tolerance_ = tolerance; }
  double getFitTolerance() const { return fit_tolerance_; } ///< The value of setFitTolerance.

  /** Called with the share done; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }
  /** The former form: with the share only. */
  template <typename ShareAlone, typename = std::enable_if_t<is_share_callback<ShareAlone>>>
  [[deprecated("a callback of the share and the stage's name")]] void setProgressCallback(ShareAlone callback)
  {
    setProgressCallback(withStage(std::move(callback)));
  }

  /** Make the lines. \p lines is empty on failure: no cloud, settings or indices out of range, no surface in the points,
   *  loops that do not belong to it, a centre off it, or lines that cannot be found. getStatus reports which and where; the
   *  getters below are then empty. */
  void compute(std::vector<RadialLine>& lines);
  /** The same, with the boundaries from line 0 on and their corners: the input of SpiralToolpathGenerator::setRadialLines. */
  void compute(RadialLineSet& set);

  /** Where the lines of the last compute start; with two boundaries the mean of the inner loop. */
  const Eigen::Vector3d& getCenter() const { return set_.centre; }
  /** True if the lines of the last compute are those of the harmonic function; if it was the fallback, the reason. */
  bool usedHarmonic() const { return set_.harmonic; }
  const Diagnostic& getWhyHarmonic() const { return set_.why_harmonic; } ///< Reason of the fallback; empty without it.
  /** Largest error, mm, of a turn between neighbouring lines of the last compute; measured. */
  double getInterpolationError() const { return set_.largest_interpolation_error; }
  /** The rim of the last compute, closed, from the end of line 0. */
  const Polyline& getRim() const { return set_.rim; }
  /** The inner boundary in the same way, from the start of line 0; empty with one boundary. */
  const Polyline& getInner() const { return set_.inner; }
  /** Entries of getRim() where it turns sharply. */
  const std::vector<std::size_t>& getRimCorners() const { return set_.rim_corners; }
  const std::vector<std::size_t>& getInnerCorners() const { return set_.inner_corners; } ///< Entries of getInner() where it turns sharply.
  /** The loops that the lines were made from, given or found. */
  const std::vector<BoundaryLoop>& getLoops() const { return loops_; }

private:
  Status check() const;
  Status run();

  std::vector<BoundaryLoop> given_loops_;
  std::optional<Eigen::Vector3d> center_, start_point_;
  LineMethod method_ = LineMethod::Automatic;
  BoundaryMode mode_ = BoundaryMode::Automatic;
  double tolerance_ = 0.05;
  double fit_tolerance_ = 1e-3;
  ProgressCallback progress_;
  std::vector<BoundaryLoop> loops_;
  RadialLineSet set_; ///< its lines are moved to the output
};

} // namespace pcl_spiral

#include <pcl_spiral/spiral/impl/radial_lines.hpp>

namespace pcl_spiral {
extern template class RadialLines<pcl::PointXYZ>;
extern template class RadialLines<pcl::PointXYZRGB>;
extern template class RadialLines<pcl::PointNormal>;
} // namespace pcl_spiral
