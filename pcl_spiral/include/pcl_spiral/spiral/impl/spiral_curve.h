// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The spiral between radial lines, before it is put on the surface.
 */
#pragma once

#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/impl/turn_function.h>
#include <pcl_spiral/spiral/spiral_path.h>

#include <vector>

namespace pcl_spiral {

/** The turns of a spiral as one curve. It passes through line i of turn j at T_i = j + delta_i, with delta_i the line's share of the
 *  rim. So line n of turn j is exactly line 0 of turn j + 1. Then follows one turn along the rim (and first one along the inner
 *  loop, if there is one). Cubic between lines; a corner stays where a line ends on a corner of the rim.
 *  Source: Wu et al. 2025, equations (17)-(19), corrected.
 */
class SpiralCurve {
public:
  SpiralCurve(const std::vector<RadialLine>& lines, const TurnFunction& turns, const SpiralSettings& settings, double spacing);

  /** The rim, closed, from line 0 on, and which of its entries are corners. */
  void setRim(Polyline rim, std::vector<std::size_t> corners);
  /** The inner loop in the same way. Without it the surface has one boundary. */
  void setInner(Polyline inner, std::vector<std::size_t> corners);

  /** Points along the whole spiral, no farther apart than the chord error and the longest step allow. */
  std::vector<SpiralPoint> sample() const;

  /** Longest step allowed anywhere, mm. */
  double largestAllowedStep() const { return max_step_; }

private:
  /** A point the curve passes through. */
  struct Knot {
    Eigen::Vector3d position;
    double turn;
    double step; ///< longest linear move here, from the curvature of the surface
    bool corner; ///< the tangent may jump
    bool anchor; ///< a path point stands here, so that each turn is sampled separately
  };
  struct ClosedLoop {
    Polyline points;
    std::vector<std::size_t> corners;
    std::vector<double> line_shares; ///< share of the loop's length at which each line meets it; 1 at the end
    bool at_rim = true;
  };

  void findActiveShares();
  std::vector<Knot> knots() const;
  std::vector<Knot> turnKnots(std::size_t turn) const;
  void meetLines(ClosedLoop& loop) const;
  std::vector<Knot> loopKnots(const ClosedLoop& loop, double turn) const;
  std::vector<Knot> turnBesideLoop(const ClosedLoop& loop, std::size_t turn) const;
  /** Derivative over chord length at knot \p k; at a corner, of the side \p after_corner or before it. */
  static Eigen::Vector3d tangent(const std::vector<Knot>& knots, std::size_t k, bool after_corner);
  /** Of every knot, as the curve leaves it. */
  static std::vector<Eigen::Vector3d> tangents(const std::vector<Knot>& knots);
  /** As the curve arrives at knot \p k: it differs from \p leaving at corners only. */
  static Eigen::Vector3d arriving(const std::vector<Knot>& knots, const std::vector<Eigen::Vector3d>& leaving, std::size_t k);
  /** Steps that each segment needs; \p leaving: tangents(). */
  std::vector<double> stepsNeeded(const std::vector<Knot>& knots, const std::vector<Eigen::Vector3d>& leaving) const;

  const std::vector<RadialLine>& lines_;
  const TurnFunction& turns_;
  SpiralSettings settings_;
  double spacing_;
  double max_step_;
  std::vector<double> active_from_; ///< share of each line below which it is too close to its neighbours to be used
  ClosedLoop rim_, inner_;
};

} // namespace pcl_spiral
