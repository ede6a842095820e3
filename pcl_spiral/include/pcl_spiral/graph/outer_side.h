// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How the outer side of a surface was found.
 */
#pragma once

#include <cstdint>

namespace pcl_spiral {

/** What decided the outer side of a surface. */
enum class SideVote : std::uint8_t {
  GivenNormals, ///< the normals given with the points
  ViewPoint,    ///< the side that faces the view point
  PlusZ,        ///< the side that faces +z
  Convex,       ///< the convex side: +z did not decide
  ToolAxis      ///< the side from which the tool comes (BallClosing)
};

/** The outer side of a surface, and how clearly it was found. Means and shares are by area. All normals are oriented together,
 *  so a vote decides only the common sign. The figures are those of the vote, before SurfaceSettings::flip_normals. */
struct OuterSide {
  SideVote vote = SideVote::PlusZ; ///< what decided
  double mean_cosine = 1.0;        ///< mean cosine between the normals and the direction of the vote, 0 to 1
  double agreement = 1.0;          ///< share of the area whose normals agree with the vote, 0 to 1
  double z_cosine = 0.0;           ///< mean cosine between the normals and +z, -1 to 1
  double view_cosine = 0.0;        ///< mean cosine between the normals and the direction of the view point, -1 to 1; 0: none
  double convex_cosine = 0.0;      ///< mean cosine with the direction from the centroid, -1 to 1; below 0: the hollow side
  double view_spread = 0.0;        ///< 1 minus the length of the mean direction to the view point; 1: the surface surrounds it
  double normals_agreement = 0.0;  ///< share of the area whose given normals agree with each other; 0: none were given
  bool normals_ignored = false;    ///< the given normals had no common side, see SurfaceSettings::trust_normals
  bool flipped = false;            ///< the other side was asked for (SurfaceSettings::flip_normals)
};

} // namespace pcl_spiral
