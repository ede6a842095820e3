// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From the curve of a spiral to a toolpath: contacts on the surface, tool axes, checks. Each step is a function of its arguments only.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/polyline.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral {

/** A toolpath as parallel arrays, in double precision. Other forms are derived from it. */
struct SpiralPath {
  Polyline contacts;
  std::vector<Eigen::Vector3d> normals; ///< unit, out of the material
  std::vector<Eigen::Vector3f> axes;    ///< unit, tip to shank
  std::vector<double> arc_lengths;      ///< cut so far, mm: lifts do not count
  std::vector<float> turns;
  std::vector<std::uint8_t> over_gap; ///< 1 where the scan has a gap
  std::vector<std::size_t> passes;    ///< where the second and each later pass begins, with the tool lifted before; empty: one
};

/** Result of measureGaps. */
struct GapFigures {
  std::size_t points = 0; ///< path points over gaps of the scan
  double length = 0.0;    ///< length of the path between them, mm
};

/** Result of setToolAxes, degrees. */
struct AxisFigures {
  double largest_change = 0.0;      ///< between neighbouring path points
  double largest_rate = 0.0;        ///< per mm of path
  double largest_lean = 0.0;        ///< between axis and normal
  double largest_deviation = 0.0;   ///< between an axis and the requested tilt
  std::size_t deviating_points = 0; ///< number with a deviation above SpiralSettings::axis_deviation
};

/** Result of checkPath. */
struct PathFigures {
  std::size_t turns = 0;
  std::size_t points = 0;
  double length = 0.0;      ///< mm
  double largest_gap = 0.0; ///< longest linear move, mm
};

/** True if \p place lies over a void of the scan (ScanVoids), or over no point of it except a point that was put into a gap:
 *  \p nearest is the nearest point of \p surface, \p distance away, mm. */
bool isOverGap(const Surface& surface, const Eigen::Vector3d& place, std::uint32_t nearest, double distance);

/** Count the marks in \p path. Fails at the first mark with GapHandling::Refuse. */
Status measureGaps(const SpiralPath& path, const SpiralSettings& settings, GapFigures& figures);

/** Put \p curve on \p surface: contacts, normals, turns and gap marks of \p path. Fails where the curve leaves the surface,
 *  where the cutter does not fit, and over a gap with GapHandling::Refuse. A step stretched beyond \p longest_step, mm,
 *  gets a point in its middle. */
Status putOnSurface(const std::vector<SpiralPoint>& curve, const Surface& surface, const SpiralSettings& settings, double longest_step,
                    const ProgressCallback& progress, SpiralPath& path, GapFigures& figures);

/** Tool axes of \p path: tilted, smoothed, limited to the largest rate. Fails where the axis would lie in the surface. */
Status setToolAxes(const SpiralSettings& settings, SpiralPath& path, AxisFigures& figures, std::vector<std::string>& warnings);

/** Fails on a move longer than \p longest_step or if the path crosses itself. */
Status checkPath(const SpiralPath& path, const SpiralSettings& settings, double longest_step, const ProgressCallback& progress,
                 PathFigures& figures);

} // namespace pcl_spiral
