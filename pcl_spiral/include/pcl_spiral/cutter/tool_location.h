/** \file
 *  Where a cutter stands, and how that was found.
 */
#pragma once

#include <pcl_spiral/cutter/impl/holder_collision.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pcl_spiral {

/** How a location turned out. */
enum class LocationState {
  Touching, ///< no contact was asked for: the cutter came down along the axis until it touched
  Reached,  ///< it touches at the contact asked for, within the tolerance
  Lifted,   ///< something else would be cut into first: the cutter stands off the contact, along the axis, by
            ///< lift
  Clear, ///< the contact asked for stands off the scan by more than the tolerance; the cutter was left there
  Unreachable, ///< the surface leans over the flank at the contact; the cutter stands beside it, free of
               ///< gouge
  NoCloud      ///< no point, or part of a mesh, within the cutter's radius of the axis, nor a contact asked for on the surface:
               ///< nothing is known, and the tip is not a number
};
constexpr std::size_t location_states = 6;

/** What the height of a location was taken from. */
enum class LocationBasis {
  FittedSurface,  ///< the surface fitted to the points about the contact; the curved surface of a mesh
  PointsAndBound, ///< the points, and the bound of how far the cutter would sink between them on top (gap)
  Points,         ///< the points alone: as published, or where there is no bound (gap_bound infinite); a mesh's flat faces
  AskedContact    ///< the contact asked for, where a height along the axis says nothing: flanks along steep
                  ///< walls, and cutters between the points. No point is deeper in the cutter, along its
                  ///< surface's normal, than the tolerance and the noise allowance
};
constexpr std::size_t location_bases = 4;

/** A gouge-free place of the cutter. Lengths in mm, along the tool axis unless said otherwise. */
struct ToolLocation {
  Eigen::Vector3d tip = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< unit, tip to shank
  Eigen::Vector3d contact =
      Eigen::Vector3d::Zero(); ///< what the cutter met first: on the surface, or a point of the scan
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< of the fitted surface, or of the mesh, there; zero without
  LocationState state = LocationState::NoCloud;
  LocationBasis basis = LocationBasis::Points;
  double lift = 0.0; ///< above the place where the cutter touches at the contact asked for; negative where it
                     ///< would have to go down to meet the scan (Clear). 0 when no contact was asked for
  double gap = 0.0;  ///< how much higher than on the points alone; slightly negative where a point stands
                     ///< above the fitted surface by noise
  double gap_bound =
      0.0; ///< bound of how far the cutter sinks between the points here, see samplingGap; may be infinite
  bool over_rim = false; ///< the cutter stands partly beyond the scan's rim, or over a gap in it, where
                         ///< something higher may be
  double rim_clearance =
      0.0; ///< of the cutter above the rim there, the least; 0 where it is not over the rim
  std::uint32_t cloud_index = 0; ///< of the point that a cutter on the points alone meets first; on a mesh, of the face
                                 ///< that is touched, among those of its SurfaceMesh
  double retilt = 0.0;           ///< degrees between the axis asked for and axis
  HolderCollision collision;     ///< of shank or holder with the scan
};

using ToolLocations = std::vector<ToolLocation>;

/** The states and bases of many locations, counted, and their largest values with the location's index. */
struct LocationFigures {
  std::array<std::size_t, location_states> states{};
  std::array<std::size_t, location_bases> bases{}; ///< NoCloud counts in none
  std::size_t over_rim = 0, retilted = 0, collisions = 0;
  double least_rim_clearance = 0.0; ///< of those over the rim
  double largest_retilt = 0.0;      ///< degrees
  double deepest_collision = 0.0;
  std::size_t most_collided = 0;
  double largest_lift = 0.0;
  std::size_t most_lifted = 0;
  double largest_gap = 0.0;       ///< taken back: what the cutter would have sunk between points
  double largest_gap_bound = 0.0; ///< finite ones of locations on the points
  std::size_t unbounded = 0;      ///< on points alone without a bound
  double noise_allowance =
      0.0; ///< a point of the scan is no deeper than this, along the surface's normal, in the cutter
  std::size_t stray_points = 0; ///< of the scan, alone off its surface: the cutter stays off them as well
  std::vector<std::string> warnings;

  std::size_t
  count(LocationState state) const
  {
    return states[static_cast<std::size_t>(state)];
  }
  std::size_t
  count(LocationBasis basis) const
  {
    return bases[static_cast<std::size_t>(basis)];
  }
};

/** A word for people: "reached", "lifted". */
const char* nameOf(LocationState state);
const char* nameOf(LocationBasis basis);

} // namespace pcl_spiral
