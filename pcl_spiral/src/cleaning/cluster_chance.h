// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How large a group of false echoes chance makes.
 */
#pragma once

#include <pcl_spiral/cleaning/standing_cluster.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Number of points from which on one of \p groups, linked by steps of \p reach, is larger than chance makes it: groups of that size are
 *  expected less than 0.3 times. How near echoes are is estimated from the pairs of groups one to three \p reach apart, which are eight
 *  times as many on a plane, and more in space. A thing whose points stand apart, as the leaves of a tree, makes pairs, too: the mean of a
 *  Poisson distribution is at most ln 2 above its median (Choi 1994), and so what is above that of half the groups does not count. */
std::size_t leastCluster(const std::vector<StandingCluster>& groups, double reach);

/** Echoes spread evenly at random over a surface. Lengths in mm. */
struct EchoSpread {
  std::size_t count = 0;
  double area = 0.0;  ///< of the surface
  double depth = 0.0; ///< of the layer that they fill over it; 0: they all lie on it

  /** How many others are within \p reach of one, at most: in a disc on the surface, in a ball where the layer is deeper. */
  double othersWithin(double reach) const;
  /** Whether so few are that chance links an echo with one other in the mean, or less. */
  bool isRare(double reach) const;
  /** The reach up to which they are rare. */
  double rareReach() const;
  /** The same as leastCluster for groups of them. */
  std::size_t leastGroup(double reach) const;
};

/** Depth of the layer that echoes of these \p heights fill: twice the shortest interval with half of them, so that a few that are far up
 *  do not count; 0 of fewer than two. */
double echoDepth(std::vector<double> heights);

} // namespace pcl_spiral
