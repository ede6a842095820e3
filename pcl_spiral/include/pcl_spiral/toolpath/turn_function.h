/** \file
 *  How many turns lie between the start of a radial line and a place on it.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/toolpath/radial_line.h>
#include <pcl_spiral/toolpath/spiral_settings.h>

#include <optional>
#include <vector>

namespace pcl_spiral {

/** T_i(s) = integral over arc length of cos psi / l, for every radial line i.
 *
 *  l is the exact step-over for the normal curvature across the feed, psi the angle between the line and the normal of
 *  the contour (the turn's direction), so that the distance of turns across the feed never exceeds l. Contours join
 *  places of equal share T_i(s) / T_i(L_i), so psi depends on T: found by a few rounds from cos psi = 1, cos psi smoothed
 *  across lines each time, because the rounds amplify what is finer than that. A last round measures psi again and adds
 *  the turns that are still needed somewhere.
 *  Source: Wu et al. 2025, equations (16)-(19), corrected: pitch across the feed, turns shared by all lines.
 */
class TurnFunction {
public:
  /** \p spacing of the cloud: contour directions are taken over at least twice that. The lines must outlive this. */
  TurnFunction(const std::vector<RadialLine>& lines, const SpiralSettings& settings, double spacing);

  /** Ok, or where the cutter does not fit. */
  Status compute();

  /** Smallest whole number of turns that keeps every pitch within the step-over. */
  std::size_t turns() const { return turns_; }
  /** Arc length on line \p i at turn \p tau, 0 to turns(). */
  double arcLengthAt(std::size_t i, double tau) const;
  /** Share of the line's turns below arc length s, 0 to 1. */
  double shareAt(std::size_t i, double s) const;
  /** Longest linear move in the feed's direction at arc length \p s of line \p i, from the chord error. */
  double feedStepAt(std::size_t i, double s) const;

  double smallestStepOver() const { return smallest_step_over_; }
  double largestStepOver() const { return largest_step_over_; }

private:
  struct Station {
    double density = 0.0;   ///< 1 / l, for the normal curvature across the feed
    double cosine = 1.0;    ///< of psi
    double rate = 0.0;      ///< dT/ds
    double turns = 0.0;     ///< T
    double feed_step = 0.0; ///< mm
  };

  Eigen::Vector3d positionOn(std::size_t line, double share) const;
  std::optional<Eigen::Vector3d> contourDirection(std::size_t line, std::size_t station, int side) const;
  std::optional<Station> stationAt(std::size_t line, std::size_t station, bool with_contours) const;
  void smoothCosines();
  void integrate(std::size_t line);
  double turnsNeeded(const std::vector<std::vector<Station>>& measured) const;

  const std::vector<RadialLine>& lines_;
  const SpiralSettings& settings_;
  double spacing_;
  double max_step_;
  std::vector<std::vector<Station>> stations_;
  std::size_t turns_ = 0;
  double smallest_step_over_ = 0.0, largest_step_over_ = 0.0;
};

} // namespace pcl_spiral
