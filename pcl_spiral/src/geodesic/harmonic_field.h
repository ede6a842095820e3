// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines from a centre, or an inner loop, to the rim of a surface. They cannot cross: they are gradient lines of a harmonic
 *  function.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/fit/impl/mls_surface.h>

#include <memory>
#include <vector>

namespace pcl_spiral {

struct HarmonicDomain;

/** The harmonic function u of a surface with u = 1 on the rim and u = 0 about a centre or on an inner loop, and its
 *  gradient lines.
 *
 *  u has no extremum inside. So from every place of the rim one line of steepest descent leads to the centre or the inner
 *  loop, and no two lines meet on the way. The lines are traced as level lines of the conjugate function v, the angle
 *  about the centre on a flat disc, which is solved for separately (it grows by 2 pi once round): a level line of a
 *  piecewise linear function neither stops early nor crosses another. Other boundary loops (gaps in the scan) let nothing
 *  through; lines go round them.
 *  Weights are positive cotangents (Pinkall and Polthier 1993); the time is that of two sparse solutions.
 *
 *  Lengths in mm; indices are those of the graph, which must outlive the field. Every const member may be called from
 *  several threads at a time.
 */
class HarmonicField {
public:
  HarmonicField();
  ~HarmonicField();
  HarmonicField(HarmonicField&&) noexcept;
  HarmonicField& operator=(HarmonicField&&) noexcept;

  /** One boundary. \p centre on the surface, at least three spacings from the rim; \p rim_points: points of the outer
   *  loop, in any order. u falls like the logarithm of the distance about the centre and is 0 within two spacings. */
  Status compute(const SurfaceGraph& graph, const Eigen::Vector3d& centre, const std::vector<std::uint32_t>& rim_points);

  /** Two boundaries. \p inner_curve: the inner outline, closed, on which the lines begin. */
  Status compute(const SurfaceGraph& graph, const std::vector<std::uint32_t>& inner_points, const Polyline& inner_curve,
                 const std::vector<std::uint32_t>& rim_points);

  /** u at point \p i of the graph; NaN on parts of the cloud that are not joined to the rim. */
  double value(std::size_t i) const { return height_[i]; }

  /** The line to \p on_rim, a point of the outline, up to about a spacing outside the outermost points: from the centre
   *  exactly, or from the inner curve, outwards, to \p on_rim exactly. Its other points are about two spacings apart, on the
   *  surface. Empty before a successful compute, and if \p on_rim is farther than four spacings from the cloud. */
  Polyline trace(const Eigen::Vector3d& on_rim) const;
  /** The lines to many points, in parallel. */
  std::vector<Polyline> trace(const Polyline& on_rim) const;

private:
  /** A half-edge that starts below a level and ends above it. */
  struct LevelEdge {
    std::uint32_t half_edge;
    double above; ///< the level, relative to the value at the start
  };
  Status solveFields(const std::vector<std::uint32_t>& inner_points, const std::vector<std::uint32_t>& rim_points);
  bool solveHeight(const std::vector<double>& weight, const std::vector<std::uint32_t>& inner_points,
                   const std::vector<std::uint32_t>& rim_points);
  bool solveAngle(const std::vector<double>& weight);
  void levelRim();
  void levelInnerCurve(const Polyline& inner_curve);
  double angleAt(const Eigen::Vector3d& point, std::uint32_t nearest) const;
  Eigen::Vector3d onEdge(const LevelEdge& at) const;
  bool passTriangle(LevelEdge& at) const;
  Polyline levelLine(double angle) const;
  Polyline smoothLine(const Eigen::Vector3d& on_rim) const;
  Eigen::Vector3d onInnerCurve(double angle) const;
  double growth(std::uint32_t half_edge) const;

  const SurfaceGraph* graph_ = nullptr;
  std::unique_ptr<MlsSurface> surface_;
  std::unique_ptr<HarmonicDomain> domain_;
  std::vector<double> height_, angle_; ///< u, and v up to whole turns
  std::vector<double> rim_angle_;      ///< v at the start of each half-edge of the rim, growing, and at the end
  Polyline inner_curve_;
  std::vector<double> inner_angle_; ///< v at each point of the inner curve, growing, and at its end
};

} // namespace pcl_spiral
