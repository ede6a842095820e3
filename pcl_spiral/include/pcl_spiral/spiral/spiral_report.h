// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input and results of a spiral toolpath.
 */
#pragma once

#include <pcl_spiral/collision/surroundings.h>
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/graph/outer_side.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/impl/missed_points.h>

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** What was done with one hole. */
struct HoleReport {
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< its middle
  double width = 0.0;                              ///< its largest extent, mm
  HoleHandling handling = HoleHandling::Around;    ///< Around or Over
};

/** A place that the ball does not reach: where more than the scallop height stays, in a hollow or under a cluster that it rides over. */
struct TightPlace {
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< of the surface, under the most stock
  double height = 0.0;                             ///< of the stock there, mm
  double area = 0.0;                               ///< of the surface under more stock than the scallop height, mm^2
  double radius = 0.0;                             ///< of the largest ball that reaches all of it, mm, apart from clusters
  bool under_cluster = false;                      ///< a cluster of points stands there, see ClusterHandling::Ride
};

/** What the surface was made of. Lengths in mm. */
struct ScanReport {
  std::size_t input_points = 0;     ///< of the cloud, or of its indices
  std::size_t nonfinite_points = 0; ///< left out
  std::size_t duplicate_points = 0; ///< left out
  std::size_t surplus_points = 0;   ///< left out: much closer together than the points around them, as along scan lines
  std::size_t outlier_points = 0;   ///< left out: by the filter, isolated, or in clusters apart from the surface
  std::size_t left_out_parts = 0;   ///< separate parts other than the largest, left out on request
  std::size_t left_out_points = 0;  ///< in these parts
  std::size_t used_points = 0;      ///< that the surface was made of
  double spacing = 0.0;             ///< median distance of neighbouring points
  int passes = 0;                   ///< over all neighbourhoods, for surface and gaps; 0 for a given surface. The program adds the check's
  double noise = 0.0;               ///< standard deviation of the points about the fitted surface
  OuterSide side;                   ///< what decided the side of the cutter, and how clearly
  int projection_neighbours = 0;    ///< neighbours in one surface fit
};

/** \deprecated Use ScanReport. */
using ScanFigures [[deprecated("use ScanReport")]] = ScanReport;

/** Boundaries of the surface. */
struct OutlineReport {
  std::vector<BoundaryLoop> loops; ///< rim, holes and gaps, as found or given
  std::vector<HoleReport> holes;   ///< holes and gaps
};

/** \deprecated Use OutlineReport. */
using OutlineFigures [[deprecated("use OutlineReport")]] = OutlineReport;

/** Lines of SpiralMethod::Radial. Lengths in mm. */
struct LineReport {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(); ///< of the spiral, with one boundary only
  bool centre_settled = true;                       ///< the search for the centre converged
  bool harmonic_lines = false;                      ///< the fallback made the lines
  std::vector<Polyline> radial_lines;               ///< from the centre, or the inner loop, to the rim
  std::size_t unsettled_lines = 0;                  ///< geodesics whose last iteration still required a move
  double largest_unsettled = 0.0;                   ///< the largest of these moves, sideways
  double line_error = 0.0;                          ///< of a turn between neighbouring lines, measured
  double line_tolerance = 0.0;                      ///< its tolerance
};

/** \deprecated Use LineReport. */
using LineFigures [[deprecated("use LineReport")]] = LineReport;

/** Loops of SpiralMethod::ConstantScallop, see ScallopReport. Lengths in mm. */
struct LoopReport {
  std::size_t scallop_loops = 0;       ///< their number
  std::size_t chain_loops = 0;         ///< loops in the spiral from the rim inward
  std::size_t bridges = 0;             ///< loops beside it
  std::size_t fingers = 0;             ///< places where loops reach out so that no higher ridge is left
  std::vector<Polyline> scallop_lines; ///< the loops, closed, simplified for pictures
  std::vector<Polyline> finger_axes;   ///< middle lines of their fingers, along the ridges
  double reversed_share = 0.0;         ///< of the path, travelled against the requested sense
  double lift_length = 0.0;            ///< of the straight moves from pass to pass, mm; not part of path_length
  double turn_radius = 0.0;            ///< of the sharpest turns, in step-overs: all but 0.1 % of the path have a larger radius
  Eigen::Vector3d sharpest_place = Eigen::Vector3d::Zero(); ///< the place of the sharpest turn
};

/** \deprecated Use LoopReport. */
using LoopFigures [[deprecated("use LoopReport")]] = LoopReport;

/** The turns of one method, before they are on the surface. Lengths in mm. */
struct TurnPlan : LineReport, LoopReport {
  SpiralMethod method = SpiralMethod::Radial; ///< that made the path
  bool own_curve = false;                     ///< of setCurve or setPlanner: method then tells by whose rules it was checked
  std::size_t boundaries = 0;                 ///< 1 or 2
  double least_length = 0.0;                  ///< of any path at this scallop height
  double smallest_step_over = 0.0;            ///< between neighbouring turns, measured on the path by measureTurns
  double largest_step_over = 0.0;             ///< that the scallop height allows
  double largest_allowed_step = 0.0;          ///< longest linear move that the chord error and SpiralSettings::max_step allow
  double corner_ridge = 0.0;                  ///< predicted height of ridges at corners, if above the scallop height; else 0; the
                                              ///< tool radius if material is left uncut
};

/** The path on the surface. Lengths in mm. */
struct SpiralPathReport {
  std::vector<std::size_t> pass_begins;                    ///< path points before which the tool is lifted; empty: one pass
  double efficiency = 0.0;                                 ///< least_length / path_length, of the whole surface
  std::size_t turns = 0;                                   ///< of the path, including those along the rim and the inner loop
  std::size_t path_points = 0;                             ///< of the path
  double path_length = 0.0;                                ///< cut; lifts do not count
  std::size_t gap_points = 0;                              ///< path points over gaps of the scan
  double gap_length = 0.0;                                 ///< length of the path between them
  Eigen::Vector3d closest_place = Eigen::Vector3d::Zero(); ///< where neighbouring turns are closest
  std::size_t reversals = 0;                               ///< places where the path turns back on itself, see PathReversals
  double largest_gap = 0.0;                                ///< longest linear move
};

/** \deprecated Use SpiralPathReport. */
using PathCounts [[deprecated("use SpiralPathReport")]] = SpiralPathReport;

/** Places that the ball does not reach. Lengths in mm. */
struct TightReport {
  std::vector<TightPlace> tight_places; ///< the highest stock first
  double fitting_radius = 0.0;          ///< of the largest ball that reaches everything, at most the tool radius
  double lifted_length = 0.0;           ///< of the path, off the surface where the ball does not reach it
  double largest_lift = 0.0;            ///< off the surface
  MissedPoints missed;                  ///< points of the scan that stand out of the surface, into which the path cuts
};

/** \deprecated Use TightReport. */
using TightFigures [[deprecated("use TightReport")]] = TightReport;

/** The tool axes of the path. */
struct SpiralAxisReport {
  double largest_axis_change = 0.0;    ///< degrees between neighbouring path points
  double largest_axis_rate = 0.0;      ///< degrees per mm of path
  double largest_axis_lean = 0.0;      ///< degrees between axis and normal
  double largest_axis_deviation = 0.0; ///< degrees between an axis and the requested tilt
  std::size_t deviating_points = 0;    ///< number with a deviation above SpiralSettings::axis_deviation
};

/** \deprecated Use SpiralAxisReport. */
using AxisCounts [[deprecated("use SpiralAxisReport")]] = SpiralAxisReport;

/** Figures of a run, those of each stage in a struct of their own. */
struct SpiralReport : ScanReport, OutlineReport, TurnPlan, SpiralPathReport, TightReport, SpiralAxisReport {
  double foreseen_radial = 0.0;          ///< predicted length of the radial path, used to choose the method, mm; 0: not predicted
  double foreseen_scallop = 0.0;         ///< the same for ConstantScallop
  std::optional<BlockedWay> blocked_way; ///< set if a path was made and then refused for what stands around the part
  std::vector<StageCost> stages;         ///< time and memory, in the order they ran
  Diagnostics warnings;                  ///< in full sentences, with the remedy
};

} // namespace pcl_spiral
