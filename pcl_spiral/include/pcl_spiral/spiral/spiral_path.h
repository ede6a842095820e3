/** \file
 *  From a spiral's curve to a toolpath: contacts on the surface, tool axes, checks. Each step is a function of what it is given.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/impl/polyline.h>
#include <pcl_spiral/surface/surface.h>
#include <pcl_spiral/spiral/impl/spiral_curve.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral {

/** A toolpath as parallel arrays: in double precision what others are derived from. */
struct SpiralPath {
  Polyline contacts;
  std::vector<Eigen::Vector3d> normals; ///< unit, out of the material
  std::vector<Eigen::Vector3f> axes;    ///< unit, tip to shank
  std::vector<double> arc_lengths;    ///< cut so far, mm: lifts do not count
  std::vector<float> turns;
  std::vector<std::uint8_t> over_gap; ///< 1 where the scan has a gap
  std::vector<std::size_t> passes;    ///< where the second pass begins, and each further one, with the tool lifted before; empty: one
};

/** What measureGaps met. */
struct GapFigures {
  std::size_t points = 0; ///< of the path, over gaps of the scan
  double length = 0.0;    ///< of the path between them, mm
};

/** What setToolAxes came to, degrees. */
struct AxisFigures {
  double largest_change = 0.0;    ///< between neighbouring path points
  double largest_rate = 0.0;      ///< per mm of path
  double largest_lean = 0.0;      ///< between axis and normal
  double largest_deviation = 0.0; ///< between an axis and the tilt asked for
  std::size_t deviating_points = 0; ///< at which it is above SpiralSettings::axis_deviation
};

/** What checkPath measured. */
struct PathFigures {
  std::size_t turns = 0;
  std::size_t points = 0;
  double length = 0.0;      ///< mm
  double largest_gap = 0.0; ///< longest linear move, mm
};

/** Whether \p place lies over a void of the scan (ScanVoids) or over no point of it, but perhaps over one that was put into a gap:
 *  \p nearest is the nearest point of \p surface, \p distance off, mm. */
bool
isOverGap(const Surface& surface, const Eigen::Vector3d& place, std::uint32_t nearest, double distance);

/** Count what is marked in \p path. Fails at the first mark with GapHandling::Refuse. */
Status
measureGaps(const SpiralPath& path, const SpiralSettings& settings, GapFigures& figures);

/** Put \p curve on \p surface: contacts, normals, turns and gap marks of \p path. Fails where the curve leaves the surface,
 *  where the cutter does not fit, and over a gap with GapHandling::Refuse. Steps that are stretched beyond \p longest_step, mm,
 *  get a point in their middle. */
Status
putOnSurface(const std::vector<SpiralPoint>& curve, const Surface& surface, const SpiralSettings& settings,
             double longest_step, const ProgressCallback& progress, SpiralPath& path, GapFigures& figures);

/** Tool axes of \p path: tilted, smoothed, held to the largest rate. Fails where the axis would lie in the surface. */
Status
setToolAxes(const SpiralSettings& settings, SpiralPath& path, AxisFigures& figures, std::vector<std::string>& warnings);

/** Fails on a move longer than \p longest_step and on a path that crosses itself. */
Status
checkPath(const SpiralPath& path, const SpiralSettings& settings, double longest_step, const ProgressCallback& progress,
          PathFigures& figures);

} // namespace pcl_spiral
