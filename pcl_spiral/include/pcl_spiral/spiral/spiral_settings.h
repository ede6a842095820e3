// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings of a spiral toolpath.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/surface/surface_settings.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace pcl_spiral {

/** Number of boundaries between which the spiral runs. */
enum class BoundaryMode {
  Automatic,     ///< the rim and every hole of the part, as HoleHandling defines; with SpiralMethod::Radial one hole at most
  OneBoundary,   ///< the rim; holes are bridged
  TwoBoundaries, ///< the rim and the longest hole
  AllBoundaries  ///< the rim and every real hole: only with SpiralMethod::ConstantScallop
};
/** Direction of the spiral. */
enum class SpiralDirection {
  Outward, ///< from the centre, or the inner loop, to the rim
  Inward   ///< from the rim inwards
};
/** Which way the cutter travels round, seen from outside the material; the same for outward and inward. With a spindle that
 *  turns clockwise (M3), it is climb milling if uncut material lies on the right of travel: outward counter-clockwise,
 *  inward clockwise. */
enum class SpiralSense {
  CounterClockwise, ///< the rim is on the right of travel
  Clockwise         ///< the rim is on the left of travel
};
/** Direction in which the distance between neighbouring turns is measured. */
enum class Pitch {
  AcrossFeed, ///< across the feed: this distance leaves the scallop
  AlongLine   ///< along the radial line, as published (Wu et al. 2025); over-machines where lines cross turns obliquely
};
/** What to do with holes of the part: those at least SpiralSettings::hole_size wide. */
enum class HoleHandling {
  Around, ///< the path runs round them
  Over,   ///< the path runs over them, on a smooth patch, and is marked there
  Refuse  ///< a part with holes is refused
};
/** What to do with gaps: missing data, not holes of the part. */
enum class GapHandling {
  Bridge, ///< the path runs over them on a smooth patch, and is marked there
  Refuse  ///< a scan with gaps is refused
};
/** What to do with places that the ball does not reach: hollows tighter than it, corners between walls, crevices. */
enum class TightHandling {
  Ride,  ///< the ball runs over them without a gouge; what it leaves is reported. SpiralMethod::Published only warns that it gouges there
  Refuse ///< a surface with a hollow tighter than the ball is refused
};
/** How lines between the boundaries are found. */
enum class LineMethod {
  Automatic, ///< geodesics, or gradient lines of the harmonic function where geodesics merge
  Geodesic,  ///< shortest paths on the surface
  Harmonic   ///< gradient lines of the harmonic function between the boundaries
};

/** How the whole path is made. */
enum class SpiralMethod {
  Shortest,        ///< Radial or ConstantScallop: the one with the shorter predicted machine time
  Radial,          ///< turns between radial lines; every step of the published method is corrected or replaced
  ConstantScallop, ///< loops one step-over apart that follow rim and holes, linked to one path: short on any outline
  Published        ///< the published method (Wu et al. 2025), for comparison: slower, coarser, only for simple outlines
};

/** Settings of a spiral toolpath, and of the surface that it runs on. Lengths in mm, angles in degrees. */
struct SpiralSettings : SurfaceSettings {
  double tool_radius = 0.0;                             ///< ball radius; must be set
  double scallop_height = 0.0;                          ///< allowed height of the ridge between turns; must be set
  double chord_error = 0.005;                           ///< allowed distance between a linear move and the surface curve
  double max_step = 0.0;                                ///< longest linear move; 0: the tool radius
  double tilt_angle = 15.0;                             ///< side tilt of the axis about the feed direction
  double lead_angle = 0.0;                              ///< lead of the axis in the feed direction
  double max_axis_rate = 10.0;                          ///< largest turn of the axis per mm of path
  double axis_smoothing = 50.0;                         ///< shorter changes along the path are smoothed out of the axis; 0: no smoothing
  double axis_deviation = 2.0;                          ///< of the smoothed axis from the requested tilt, in the mean over its length
  std::optional<Eigen::Vector3d> fixed_axis;            ///< of the tool at every point, from tip to shank, instead of tilt and lead
  double feed = 1000.0;                                 ///< mm/min at the contact
  double acceleration = 2000.0;                         ///< of the machine along the path, mm/s2: a sharp turn costs time
  double least_turn_radius = 0.2;                       ///< of turns, in step-overs: the report of ConstantScallop warns of sharper ones
  double rim_overhang = 0.0;                            ///< of the pass along the rim: above 0 this far beyond the rim, below 0 inside it
  std::optional<Eigen::Vector3d> centre;                ///< of a surface with one boundary; absent: found
  std::optional<Eigen::Vector3d> start_point;           ///< the path meets the rim nearest here; absent: found
  BoundaryMode boundary_mode = BoundaryMode::Automatic; ///< between which boundaries the path runs
  SpiralDirection direction = SpiralDirection::Outward; ///< outward or inward
  SpiralSense sense = SpiralSense::CounterClockwise;    ///< which way round
  bool one_way = false;            ///< ConstantScallop cuts only in that sense, in several passes where loops lie beside each other
  Pitch pitch = Pitch::AcrossFeed; ///< how the distance between turns is measured
  SpiralMethod method = SpiralMethod::Shortest; ///< how the whole path is made
  HoleHandling holes = HoleHandling::Around;    ///< what to do with holes of the part
  double hole_size = 0.0;   ///< least width of a hole of the part; narrower ones are gaps in the data. 0: from the scan, BoundaryOptions
  double hole_margin = 0.0; ///< the path stays this far from holes
  GapHandling gaps = GapHandling::Bridge;    ///< what to do with gaps in the data
  TightHandling tight = TightHandling::Ride; ///< what to do with places that the ball does not reach
  LineMethod lines = LineMethod::Automatic;  ///< how radial lines are found
};

/** Those of the cutter, its axis and the finish. */
std::vector<Setting> cutterTable(SpiralSettings& settings);

/** Those of the turns. */
std::vector<Setting> turnTable(SpiralSettings& settings);

/** Both, and those of the surface. */
std::vector<Setting> settingTable(SpiralSettings& settings);

/** Allowed error of a turn between radial lines, mm: a fiftieth of the step-over on a plane. */
double lineTolerance(const SpiralSettings& settings);

/** Allowed distance of a radial line's B-spline from its points, mm. */
double lineFitTolerance(const SpiralSettings& settings);

} // namespace pcl_spiral
