// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pairs of points on two closed loops. Private to spiral.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** For each seed of one closed loop, in order, its partner on another: an index into \p candidates, which run in
 *  the same direction, plus their number after the count passes the first again. Partners never go
 *  back, and all of them together go round once.
 *
 *  Wu et al. 2025 pair the points of both loops; here the pairs have the least
 *    sum of |seed - partner| / mean distance of the loops + sum of (way to the next partner / even way -
 *  1)^2, that is, length and variance of the spacing, by dynamic programming over every start. Distances are
 *  straight. The way to the next partner is at most four times the even one. Seeds and candidates are evenly
 *  spaced; there are at least two seeds, and at least as many candidates. Time: seeds times the square of the
 *  candidates, times four times the even way. */
std::vector<std::size_t> matchLoops(const Polyline& seeds, const Polyline& candidates);

/** The cost that matchLoops minimises. */
double matchingCost(const Polyline& seeds, const Polyline& candidates, const std::vector<std::size_t>& partners);

} // namespace pcl_spiral
