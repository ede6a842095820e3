// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  From radial lines to a toolpath: turns, contacts on the surface, tool axes, checks. Each step is a function of its arguments only.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/spiral/radial_line.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral {

class BallReach;

/** A point of the unprojected spiral. */
struct SpiralPoint {
  Eigen::Vector3d position; ///< mm
  double turn;              ///< turns completed up to here
  bool begins_pass = false; ///< the tool is lifted to it
};

/** Where a point of a curve is on the surface. */
struct CurveFoot {
  Eigen::Vector3d position; ///< mm
  Eigen::Vector3d normal;   ///< unit
  double nearest_distance;  ///< from the nearest point of the scan, mm
  std::uint32_t nearest;    ///< that point
};

/** Feet of a curve that are known before it is put on the surface: those from which the length of its moves was found. */
struct CurveFeet {
  static constexpr std::uint32_t none = 0xffffffffu; ///< no foot

  std::vector<CurveFoot> feet;         ///< in any order
  std::vector<std::uint32_t> of_point; ///< index into feet of each point of the curve, or none; empty: none is known

  /** The foot of point \p i; null: it is not known. */
  const CurveFoot* find(std::size_t i) const { return i < of_point.size() && of_point[i] != none ? &feet[of_point[i]] : nullptr; }
};

/** The highest ridge that turns leave at corners. */
struct CornerRidge {
  double height = 0.0;                              ///< mm; the tool radius where material is left uncut; 0 without corners
  double widening = 1.0;                            ///< distance of turns there, as a multiple of the step-over
  double remedy = 0.0;                              ///< mm: the scallop height whose turns leave ridges of the requested height
  Eigen::Vector3d corner = Eigen::Vector3d::Zero(); ///< of the outline
};

/** The curve, before it is put on the surface, and its figures. Lengths in mm. */
struct SpiralTurns {
  std::vector<SpiralPoint> curve;    ///< in travel order
  CurveFeet feet;                    ///< of its points
  double smallest_step_over = 0.0;   ///< on the surface, along the lines
  double largest_step_over = 0.0;    ///< the largest, in the same way
  double largest_allowed_step = 0.0; ///< longest linear move
  double least_length = 0.0;         ///< lower bound for the length of any path at this scallop height
  CornerRidge corner_ridge;          ///< the highest ridge left at corners
  Diagnostics warnings;              ///< in full sentences, with the remedy
};

/** Turns between \p lines at the step-over that \p settings define (TurnFunction), drawn as one curve (SpiralCurve).
 *  \p spacing and \p area, mm2, of the surface. Fails where the cutter does not fit, where a line leaves the surface, or if the
 *  path is too large. */
Status makeTurns(const RadialLineSet& lines, double spacing, double area, const SpiralSettings& settings, SpiralTurns& turns);

/** Ok, or an error in the user's own \p lines, for a surface of this \p spacing: too few lines, wrong order, feet that are not
 *  finite or have left the surface, levels out of range or none 0, no rim, an inner boundary of one or two points. The message
 *  reports which line, and where. */
Status checkLines(const RadialLineSet& lines, double spacing);

/** A toolpath as parallel arrays, in double precision. Other forms are derived from it. */
struct SpiralPath {
  Polyline contacts;                    ///< on the surface, mm; lifted off it where the ball does not reach it
  std::vector<Eigen::Vector3d> normals; ///< unit, out of the material
  std::vector<Eigen::Vector3f> axes;    ///< unit, tip to shank
  std::vector<double> arc_lengths;      ///< cut so far, mm: lifts do not count
  std::vector<float> turns;             ///< completed up to each point
  std::vector<std::uint8_t> over_gap;   ///< 1 where the scan has a gap
  std::vector<std::size_t> passes;      ///< where the second and each later pass begins, with the tool lifted before; empty: one
  Polyline feet;                        ///< of the contacts on the surface, if any is lifted; else empty
  std::vector<float> lifts;             ///< distance of each contact from its foot, mm; empty like feet

  const Polyline& onSurface() const { return feet.empty() ? contacts : feet; } ///< The feet of all contacts.
};

/** Lengths cut up to each contact of \p path, mm. The sum is serial: its rounding depends on its order. */
std::vector<double> cutLengths(const SpiralPath& path);

/** Result of measureGaps. */
struct GapReport {
  std::size_t points = 0; ///< path points over gaps of the scan
  double length = 0.0;    ///< length of the path between them, mm
};

/** \deprecated Use GapReport. */
using GapFigures [[deprecated("use GapReport")]] = GapReport;

/** Result of setToolAxes, degrees. */
struct AxisReport {
  double largest_change = 0.0;      ///< between neighbouring path points
  double largest_rate = 0.0;        ///< per mm of path
  double largest_lean = 0.0;        ///< between axis and normal
  double largest_deviation = 0.0;   ///< between an axis and the requested tilt
  std::size_t deviating_points = 0; ///< number with a deviation above SpiralSettings::axis_deviation
};

/** \deprecated Use AxisReport. */
using AxisFigures [[deprecated("use AxisReport")]] = AxisReport;

/** Places where a path turns back by more than 150 degrees from one move to the next, a whole turn or more away from the ends of its
 *  passes. */
struct PathReversals {
  std::size_t count = 0;                           ///< of such places
  std::size_t at_corners = 0;                      ///< of them, at corners of the outline that are as sharp
  std::size_t lifted = 0;                          ///< of them, where the ball is lifted off the surface; see ballReversals
  double angle = 0.0;                              ///< degrees, the largest; if there are any, of those away from corners
  double turn = 0.0;                               ///< in which the largest is
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< of the largest
};

/** Where neighbouring turns are closest. */
struct ClosestTurns {
  double distance = 0.0;                           ///< mm; 0: the path has fewer than two turns between its first and its last
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< a contact there
};

/** Result of checkPath. */
struct ToolpathReport {
  std::size_t turns = 0;    ///< of the path
  std::size_t points = 0;   ///< of the path
  double length = 0.0;      ///< mm
  double largest_gap = 0.0; ///< longest linear move, mm
  PathReversals reversals;  ///< of the path
  ClosestTurns closest;     ///< measured on the path, see measureTurns
};

/** \deprecated Use ToolpathReport. */
using PathFigures [[deprecated("use ToolpathReport")]] = ToolpathReport;

/** True if \p place lies over a void of the scan (ScanVoids), or over no point of it except a point that was put into a gap:
 *  \p nearest is the nearest point of \p surface, \p distance away, mm. */
bool isOverGap(const Surface& surface, const Eigen::Vector3d& place, std::uint32_t nearest, double distance);

/** Count the marks in \p path. Fails at the first mark with GapHandling::Refuse. */
Status measureGaps(const SpiralPath& path, const SpiralSettings& settings, GapReport& figures);

/** Put \p curve on \p surface: contacts, normals, turns and gap marks of \p path. Fails where the curve leaves the surface,
 *  where the cutter does not fit with TightHandling::Refuse, and over a gap with GapHandling::Refuse. A step stretched beyond
 *  \p longest_step, mm, gets a point in its middle. With TightHandling::Ride, contacts are lifted off the surface where the ball does not
 *  reach it. \p reach of the ball on this surface; null: made here. */
Status putOnSurface(const std::vector<SpiralPoint>& curve, const Surface& surface, const SpiralSettings& settings, double longest_step,
                    const ProgressCallback& progress, SpiralPath& path, GapReport& figures, const BallReach* reach = nullptr);

/** The same for the curve of \p turns with its longest step. Feet that it has are not found again. */
Status putOnSurface(const SpiralTurns& turns, const Surface& surface, const SpiralSettings& settings, const ProgressCallback& progress,
                    SpiralPath& path, GapReport& figures, const BallReach* reach = nullptr);

/** Tool axes of \p path: tilted, smoothed, limited to the largest rate. Beside \p obstacles, points that the ball rides over, the tool
 *  leans less if its shank, shank_radii long, would enter them otherwise; a fixed axis stays. Fails where the axis would lie in the
 *  surface. */
Status setToolAxes(const SpiralSettings& settings, SpiralPath& path, AxisReport& figures, Diagnostics& warnings,
                   const std::vector<Eigen::Vector3f>& obstacles = {});
/** The same with warnings as texts. */
[[deprecated("Diagnostics")]] inline Status
setToolAxes(const SpiralSettings& settings, SpiralPath& path, AxisReport& figures, std::vector<std::string>& warnings,
            const std::vector<Eigen::Vector3f>& obstacles = {})
{
  Diagnostics said;
  Status status = setToolAxes(settings, path, figures, said, obstacles);
  for (const Diagnostic& warning : said)
    warnings.push_back(warning.text());
  return status;
}

/** Reversals and closest turns of \p path. The first and the last turn of each pass do not count: they run about the centre or along a
 *  boundary, where turns meet. Neighbouring turns are half a turn or more apart; with SpiralMethod::ConstantScallop they are stretches
 *  that are four flat step-overs or more apart along the path, because bridges and fingers lie side by side within a turn. */
void measureTurns(const SpiralPath& path, const SpiralSettings& settings, ToolpathReport& figures);

/** Fails on a move longer than \p longest_step, if the path crosses itself, or if it turns back on itself: with
 *  SpiralMethod::ConstantScallop, whose fingers do so, that is only counted. \p own_curve: no setting made it, so the remedy names none. */
Status checkPath(const SpiralPath& path, const SpiralSettings& settings, double longest_step, const ProgressCallback& progress,
                 ToolpathReport& figures, bool own_curve = false);

} // namespace pcl_spiral
