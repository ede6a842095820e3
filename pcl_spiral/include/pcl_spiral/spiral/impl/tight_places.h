// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a surface is hollow and tighter than the ball cutter.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/spiral/radial_line.h>
#include <pcl_spiral/surface/surface.h>

#include <optional>
#include <vector>

namespace pcl_spiral {

/** Collects feet at which the smaller curvature is -1 / radius of the ball, or less: the ball gouges beside its contact. */
class TightPlaces {
public:
  /** \p tool_radius of the ball, mm. */
  explicit TightPlaces(double tool_radius) : tool_radius_(tool_radius) {}

  /** Keeps \p foot if it is valid and too tight. The first of equally tight ones counts as the tightest. */
  void add(const SurfaceFoot& foot);
  /** Keeps the feet of \p lines that are too tight. */
  void add(const std::vector<RadialLine>& lines);

  bool empty() const { return feet_.empty(); }            ///< Whether the ball fits everywhere.
  const Polyline& feet() const { return feet_; }          ///< Feet that are too tight, in the order given, mm.
  double radius() const { return radius_; }               ///< Radius of the tightest, mm.
  const Eigen::Vector3d& place() const { return place_; } ///< Foot of the tightest, mm.
  /** Number of separate places: feet nearer to each other than half the tool radius are one place. */
  std::size_t count() const;

  /** Failed, with the tightest place, and the number of places and of feet, named \p what such as "path points". With a \p surface, the
   *  remedy is a ball that fits at all its points and at these feet; null: at these feet only. */
  Status refusal(const Diagnostic& what, const Surface* surface) const;

private:
  double tool_radius_;
  Polyline feet_;
  double radius_ = 0.0;
  Eigen::Vector3d place_ = Eigen::Vector3d::Zero();
};

/** Radius of the ball that messages name where the tightest hollow has the radius \p tightest, mm: a little less. None for an inner edge,
 *  tighter than the \p spacing of the points, which has no radius on the scan. */
std::optional<double> fittingBall(double tightest, double spacing);

/** Refuses the \p lines on \p surface if they have a foot that is too tight for \p tool_radius. Paths are put on the surface later; this
 *  check comes before turns are spaced, because no step-over exists at such a foot. */
Status checkLinesFit(const std::vector<RadialLine>& lines, const Surface& surface, double tool_radius);

} // namespace pcl_spiral
