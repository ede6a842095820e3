// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A line of close stations on which feet are found fast.
 */
#pragma once

#include <pcl_spiral/ridge/impl/smooth_line.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The foot of a point on a line, perpendicular to the line. */
struct LineFoot {
  double s = 0.0; ///< arc length
  Eigen::Vector3d position, tangent;
  bool inside = false; ///< not beyond an end
};

/** Stations of a smooth line, joined by cubics through places and tangents: the error is of fourth order in the step. */
class StationLine {
public:
  StationLine() = default;
  /** Stations about \p step apart, with \p extra of them straight beyond each end of an open line, where s is below 0 or above length. */
  StationLine(const SmoothLine& line, double step, std::size_t extra = 0);

  std::size_t size() const { return positions_.size(); }
  double step() const { return step_; }
  double s(std::size_t station) const { return (static_cast<double>(station) - static_cast<double>(extra_)) * step_; }
  const Eigen::Vector3d& position(std::size_t station) const { return positions_[station]; }
  const Eigen::Vector3d& tangent(std::size_t station) const { return tangents_[station]; }

  /** The nearest station; none (size()) if all are farther than \p reach. */
  std::uint32_t nearestStation(const Eigen::Vector3d& p, double reach) const;
  /** The foot near \p station, which is set to the station before the foot. */
  LineFoot foot(const Eigen::Vector3d& p, std::uint32_t& station) const;

private:
  struct Ball {
    Eigen::Vector3d centre;
    double radius;
  };

  double ahead(const Eigen::Vector3d& p, std::size_t i) const { return (p - positions_[i]).dot(tangents_[i]); }
  void addBalls();

  Polyline positions_, tangents_;
  std::vector<Ball> balls_; ///< about runs of stations
  double step_ = 0.0;
  std::size_t extra_ = 0;
  bool closed_ = false;
};

} // namespace pcl_spiral
