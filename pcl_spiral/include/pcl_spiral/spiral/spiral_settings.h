/** \file
 *  What a user asks of a spiral toolpath.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>

#include <Eigen/Core>

#include <optional>

namespace pcl_spiral {

/** How many boundaries the spiral runs between. */
enum class BoundaryMode {
  Automatic,     ///< the rim and every hole of the part, as HoleHandling says; with SpiralMethod::Radial one hole at most
  OneBoundary,   ///< the rim; holes are bridged
  TwoBoundaries, ///< the rim and the longest hole
  AllBoundaries  ///< the rim and every real hole: SpiralMethod::ConstantScallop alone
};
/** Which way the spiral travels. */
enum class SpiralDirection { Outward, Inward };
/** Which way the cutter travels round, seen from outside the material, outward and inward alike. With a spindle that turns
 *  clockwise (M3) the cut is a climbing one where uncut material lies on the right of travel: outward counter-clockwise,
 *  inward clockwise. */
enum class SpiralSense { CounterClockwise, Clockwise };
/** Along what the distance of neighbouring turns is measured. */
enum class Pitch {
  AcrossFeed, ///< across the feed: what leaves the scallop
  AlongLine   ///< along the radial line, as published (Wu et al. 2025); over-machines where lines meet turns obliquely
};
/** What to do with holes of the part: those at least SpiralSettings::hole_size wide. */
enum class HoleHandling {
  Around, ///< the path runs round them
  Over,   ///< the path runs over them, on a smooth patch, and is marked there
  Refuse  ///< a part with holes is refused
};
/** What to do with gaps: holes in the data that are none of the part. */
enum class GapHandling { Bridge, Refuse };
/** How lines between the boundaries are found. */
enum class LineMethod {
  Automatic, ///< geodesics, and the harmonic function's gradient lines where geodesics merge
  Geodesic,
  Harmonic
};

/** How the whole path is made. */
enum class SpiralMethod {
  Shortest, ///< Radial or ConstantScallop: the one foreseen to take less machine time
  Radial,   ///< turns between radial lines, every step of the published method mended or replaced
  ConstantScallop, ///< loops one step-over apart that follow rim and holes, linked to one path: short on any outline
  Published ///< the published chain (Wu et al. 2025), to compare with: slower, coarser, for simple outlines alone
};

/** Settings of a spiral toolpath. Lengths in mm, angles in degrees. */
struct SpiralSettings {
  double tool_radius = 0.0;    ///< ball radius; must be set
  double scallop_height = 0.0; ///< allowed height of the ridge between turns; must be set
  double chord_error = 0.005;  ///< allowed distance between a linear move and the surface curve
  double max_step = 0.0;       ///< longest linear move; 0: the tool radius
  double tilt_angle = 15.0;    ///< side tilt of the axis about the feed direction
  double lead_angle = 0.0;     ///< lead of the axis in the feed direction
  double max_axis_rate = 10.0; ///< largest turn of the axis per mm of path
  double axis_smoothing = 50.0; ///< what is shorter along the path is smoothed out of the axis; 0: nothing
  double axis_deviation = 2.0; ///< that smoothing may cause from the tilt asked for, in the mean over its length
  double feed = 1000.0;        ///< mm/min at the contact
  double acceleration = 2000.0; ///< of the machine along the path, mm/s2: what a sharp turn costs
  double least_turn_radius = 0.2; ///< of turns, in step-overs: the report of ConstantScallop warns of sharper ones
  double rim_overhang = 0.0;   ///< of the pass along the rim: above 0 beyond the rim by so much, below 0 inside it
  std::optional<Eigen::Vector3d> centre;      ///< of a surface with one boundary; absent: found
  std::optional<Eigen::Vector3d> start_point; ///< the path meets the rim nearest here; absent: found
  std::optional<Eigen::Vector3d> view_point;  ///< normals face it; absent: towards +z as a whole
  bool flip_normals = false;
  BoundaryMode boundary_mode = BoundaryMode::Automatic;
  SpiralDirection direction = SpiralDirection::Outward;
  SpiralSense sense = SpiralSense::CounterClockwise;
  bool one_way = false; ///< ConstantScallop cuts in that sense alone, in several passes where loops lie beside each other
  Pitch pitch = Pitch::AcrossFeed;
  SpiralMethod method = SpiralMethod::Shortest;
  HoleHandling holes = HoleHandling::Around;
  double hole_size = 0.0;   ///< least width of a hole of the part; narrower ones are gaps in the data. 0: by the scan, see BoundaryOptions
  double hole_margin = 0.0; ///< the path stays this far from the edges of holes
  GapHandling gaps = GapHandling::Bridge;
  LineMethod lines = LineMethod::Automatic;
  bool largest_part = false;        ///< of several separate parts keep the one of the largest area alone
  double thinning = 0.0;            ///< voxel edge of the thinning filter; 0: none
  int outlier_neighbours = 0;       ///< neighbours of the statistical outlier filter; 0: none
  double outlier_deviations = 3.0;  ///< its threshold in standard deviations
  unsigned int threads = 0;         ///< 0: all
};

} // namespace pcl_spiral
