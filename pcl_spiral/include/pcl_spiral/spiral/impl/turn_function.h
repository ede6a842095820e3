// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Number of turns between the start of a radial line and a place on it.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/radial_line.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <optional>
#include <vector>

namespace pcl_spiral {

/** T_i(s) = integral over arc length of cos psi / l, for every radial line i.
 *
 *  l is the exact step-over for the normal curvature across the feed. psi is the angle between the line and the normal of
 *  the contour (the turn's direction): the distance of turns is measured across the feed. All lines share N turns, so the
 *  share T_i(s) / T_i(L_i) of each line defines the spiral. It comes from contours of equal integral of 1 / l, smoothed
 *  across lines; any smooth function is allowed. Then psi is measured on the contours of these shares, and N is the least
 *  number that keeps every distance within l.
 *  Source: Wu et al. 2025, equations (16)-(19), corrected: pitch across the feed, turns shared by all lines.
 */
class TurnFunction {
public:
  /** \p spacing of the cloud: contour directions are taken over at least twice this length. The lines must outlive this object. */
  TurnFunction(const std::vector<RadialLine>& lines, const SpiralSettings& settings, double spacing);

  /** Use one \p step_over and one longest linear move \p step everywhere, mm, instead of those from curvature and chord
   *  error. Then it is not checked whether the cutter fits. For lengths from other rules, as those
   *  of Wu et al. 2025, equations (13)-(16). */
  void setEvenSteps(double step_over, double step);

  /** Ok, or an error where the cutter does not fit or a line has left the surface (an invalid foot between its ends). At
   *  an end that lies a little beyond the surface, the curvature is that of the next foot. */
  Status compute();

  /** Least whole number of turns that keeps every pitch within the step-over. */
  std::size_t turns() const { return turns_; }
  /** Arc length on line \p i at turn \p tau, 0 to turns(). */
  double arcLengthAt(std::size_t i, double tau) const;
  /** Share of the line's turns below arc length s, 0 to 1. */
  double shareAt(std::size_t i, double s) const;
  /** Longest linear move in the feed's direction at arc length \p s of line \p i, from the chord error. */
  double feedStepAt(std::size_t i, double s) const;

  /** Size of the spiral of these turns: points from the curvature of the surface itself, and knots. */
  PathSize pathSize() const;

  /** Turns that lie l apart along the sides of a corner lie farther apart at the corner. Their tips are p apart along the corner's
   *  line, which makes angles alpha1 and alpha2 with the sides. The place farthest from both turns lies on the bisector of
   *  the outer one, t from its tip, as far from the inner tip as from the sides of the outer one: with a = (alpha1 + alpha2) / 2,
   *  and the line b = (alpha1 - alpha2) / 2 off the bisector, (t sin a)^2 = t^2 - 2 t p cos b + p^2. The first turn is not
   *  checked. */
  CornerRidge highestCornerRidge() const;

  double smallestStepOver() const { return smallest_step_over_; }
  double largestStepOver() const { return largest_step_over_; }

private:
  struct Station {
    double rate = 0.0;      ///< 1 / l, or cos psi / l; after integration, the growth of the share per share of length
    double share = 0.0;     ///< T_i(s) / T_i(L_i)
    double feed_step = 0.0; ///< mm
  };

  const SurfaceFoot& footAt(std::size_t line, std::size_t station) const;
  double arcLengthAtShare(std::size_t line, double share) const;
  Eigen::Vector3d positionOn(std::size_t line, double share) const;
  std::optional<Eigen::Vector3d> contourDirection(std::size_t line, std::size_t station, int side) const;
  Status checkFeet() const;
  std::optional<Station> stationAt(std::size_t line, std::size_t station, bool with_contours) const;
  void smoothRates();
  void integrate(std::size_t line);
  void findStepOvers();
  double turnsNeeded(const std::vector<std::vector<Station>>& measured) const;

  const std::vector<RadialLine>& lines_;
  SpiralSettings settings_;
  double spacing_;
  double max_step_;
  double even_step_over_ = 0.0; ///< 0: from the curvature, as the feed steps
  std::vector<std::vector<Station>> stations_;
  std::size_t turns_ = 0;
  double smallest_step_over_ = 0.0, largest_step_over_ = 0.0;
};

} // namespace pcl_spiral
