// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a cutter stands, and how that place was found.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/tool_holder.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_spiral {

/** How the height of a location is found. */
enum class LocationEvaluation {
  FittedSurface,  ///< on the surface fitted to the points; where that fit cannot be trusted,
                  ///< as PointsAndBound. On a mesh: on the curved surface behind its faces
  PointsAndBound, ///< on the points, raised by the bound of how far the cutter would sink between
                  ///< them, if there is one. A mesh has no such bound: it has no gaps between points
  Points          ///< only on the points, as published: sharp cutters sink between them. On a mesh: on its flat faces
};

/** The result of a location. */
enum class LocationState {
  Touching,    ///< no contact was asked for: the cutter came down along the axis until it touched
  Reached,     ///< it touches at the contact asked for, within the tolerance
  Lifted,      ///< at the contact asked for, the cutter would cut into
               ///< another place: it stands higher, along the axis, by lift
  Clear,       ///< the contact asked for is above the scan by more than the tolerance; the cutter stays at that contact
  Unreachable, ///< the surface overhangs the flank at the contact; the
               ///< cutter stands next to the contact, without gouge
  NoCloud      ///< no point, or part of a mesh, lies within the cutter's radius of the axis, and no
               ///< contact on the surface was asked for: nothing is known, and the tip is not a number
};
constexpr std::size_t location_states = 6; ///< Number of states.

/** The data that gave the height of a location. */
enum class LocationBasis {
  FittedSurface,  ///< the surface fitted to the points near the contact; the curved surface of a mesh
  PointsAndBound, ///< the points, plus the bound of how far the cutter would sink between them (gap)
  Points,         ///< only the points: as published, or where there is no bound (gap_bound infinite); the flat faces of a mesh
  AskedContact    ///< the contact asked for, where a height along the axis means nothing: flanks along
                  ///< steep walls, and cutters between the points. No point is deeper in the cutter than
                  ///< the tolerance plus the noise allowance, measured along the normal of the surface
};
constexpr std::size_t location_bases = 4; ///< Number of bases.

/** The point that is deepest in the shank or holder, or of those above the ceiling in the cutter. Lengths in mm. */
struct HolderCollision {
  ToolPart part = ToolPart::Holder;                ///< that it is in
  int segment = -1;                                ///< of the holder, from the cutter upwards; -1: none, or cutter or shank
  double depth = 0.0;                              ///< shortest way out of it, clearance included; 0: none
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< the point
  std::uint32_t cloud_index = 0;                   ///< of the point, in the input cloud

  bool found() const { return depth > 0.0; } ///< Whether there is a collision.
};

/** A place of the cutter without gouge. Lengths in mm, along the tool axis unless stated otherwise. */
struct ToolLocation {
  Eigen::Vector3d tip = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()); ///< of the cutter; not a number with NoCloud
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();                                           ///< unit, from the tip to the shank
  Eigen::Vector3d contact = Eigen::Vector3d::Zero(); ///< the place of the cutter that touches first: the surface, or a point of the scan
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, at the contact, into the cutter: of a ball (centre - contact) / R; see
                                                     ///< CutterProfile::touchAt. Zero with NoCloud
  LocationState state = LocationState::NoCloud;      ///< result of the location
  LocationBasis basis = LocationBasis::Points;       ///< data that gave its height
  double lift = 0.0;             ///< height above the place where the cutter touches at the contact asked for. Negative if
                                 ///< it would have to go down to touch the scan (Clear). 0 if no contact was asked for
  double gap = 0.0;              ///< how much higher than on the points only; slightly negative
                                 ///< where noise puts a point above the fitted surface
  double gap_bound = 0.0;        ///< bound of how far the cutter sinks between the points here, see samplingGap; may be infinite
  bool over_rim = false;         ///< part of the cutter is beyond the rim of the scan, or
                                 ///< over a gap in it: something higher may be there
  double rim_clearance = 0.0;    ///< smallest clearance of the cutter above the rim there; 0 where it is not over the rim
  std::uint32_t cloud_index = 0; ///< of the point that a cutter on the points only touches first; on a
                                 ///< mesh, of the touched face, among the faces of its SurfaceMesh
  double retilt = 0.0;           ///< degrees between the axis asked for and axis
  HolderCollision collision;     ///< of the shank or holder with the scan, and of the cutter with what is above the ceiling
  bool under_scan = false;       ///< the scan goes on above the end of the tool, within its largest radius of the axis
};

using ToolLocations = std::vector<ToolLocation>; ///< Locations in the order of their drive points.

/** Counts of the states and bases of many locations, and their largest values with the index of the location. */
struct LocationReport {
  std::array<std::size_t, location_states> states{}; ///< number of locations in each state
  std::array<std::size_t, location_bases> bases{};   ///< NoCloud counts in none of them
  std::size_t over_rim = 0;                          ///< locations over the rim or over a gap
  std::size_t retilted = 0;                          ///< locations whose axis was turned
  std::size_t collisions = 0;                        ///< locations where shank or holder collide
  std::size_t under_scan = 0;                        ///< locations with more of the scan above the end of the tool
  std::size_t first_under_scan = 0;                  ///< index of the first of them
  double least_rim_clearance = 0.0;                  ///< of the locations over the rim
  double largest_retilt = 0.0;                       ///< degrees
  double deepest_collision = 0.0;                    ///< mm
  std::size_t most_collided = 0;                     ///< index of that location
  double largest_lift = 0.0;                         ///< mm
  std::size_t most_lifted = 0;                       ///< index of that location
  double largest_gap = 0.0;                          ///< corrected: how far the cutter would have sunk between points
  double largest_gap_bound = 0.0;                    ///< of the finite bounds, at locations on the points
  std::size_t unbounded = 0;                         ///< locations on the points only, without a bound
  double noise_allowance = 0.0;   ///< a point of the scan is no deeper than this, along the surface's normal, in the cutter
  std::size_t outlier_points = 0; ///< outliers of the scan, off its surface: the cutter stays off them too
  Diagnostics warnings;           ///< in full sentences, with the remedy

  std::size_t count(LocationState state) const { return states[static_cast<std::size_t>(state)]; } ///< Number of locations in a state.
  std::size_t count(LocationBasis basis) const { return bases[static_cast<std::size_t>(basis)]; }  ///< Number of locations of a basis.
};

/** \deprecated Use LocationReport. */
using LocationFigures [[deprecated("use LocationReport")]] = LocationReport;

/** Result of a bisection. Lengths in mm. */
struct BisectionReport {
  std::size_t inserted = 0;                              ///< locations added
  double largest_error = 0.0;                            ///< of all moves: a bound of what they cut, or what is left in
                                                         ///< the middle if that is more; plus what thinning shifts
  std::size_t unresolved = 0;                            ///< moves still beyond the tolerance; largest_error includes their error
  Eigen::Vector3d worst_place = Eigen::Vector3d::Zero(); ///< tip in the middle of the move with the largest error
  std::size_t not_judged = 0;                            ///< moves from or to a location without a cloud
};

/** \deprecated Use BisectionReport. */
using BisectionFigures [[deprecated("use BisectionReport")]] = BisectionReport;

/** The name in words: "reached", "lifted". */
const char* nameOf(LocationState state);
/** What of the tool is in the scan: a segment of \p holder by its name, or the cutter. */
Diagnostic nameOf(const HolderCollision& collision, const std::vector<ToolSegment>& holder);
const char* nameOf(LocationBasis basis); ///< The same for a basis: "fitted surface", "points".

} // namespace pcl_spiral
