// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  When a face or an edge of a mesh is straight although the mesh bends beyond its end. Private to mesh.
 */
#pragma once

namespace pcl_spiral {

/** How many times as wide, or as long, as its neighbours something is that cannot be of one bent surface with them. Measured on made
 *  meshes: with 2, random vertices of a round surface make straight edges; with 8, floors of pockets stay bent. */
constexpr double much_longer = 4.0;

/** How many times as long something must be that is told to be straight by the bend at its end alone. */
constexpr double longer = 1.5;

/** Whether something \p ratio times as long as the piece beyond its end is straight. \p share is the bend at the end as a share of that of
 *  half the piece beyond, whose curvature its far end tells, or NaN if that is not known. It is 1 if what ends is straight. If that is
 *  bent, it adds a share of \p ratio with the same curvature, of 1 with the same angle, and of 1 / \p ratio with the same chord error,
 *  as meshers make it. */
inline bool
endsStraight(double ratio, double share)
{
  if (ratio >= much_longer)
    return !(share > 1.5);
  return ratio >= longer && share < 1.0 + 0.5 / ratio;
}

} // namespace pcl_spiral
