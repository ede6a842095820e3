// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Polylines in space, double precision: lengths, resampling, smoothing.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** An ordered sequence of points. A closed polyline does not repeat its first point. Lengths in the unit of the points. */
using Polyline = std::vector<Eigen::Vector3d>;

/** Length of the polyline. With \p closed, the segment from the last point to the first counts too. */
double length(const Polyline& line, bool closed = false);

/** Arc length at each point, starting at 0. With \p closed, one more entry at the end has the whole length. */
std::vector<double> arcLengths(const Polyline& line, bool closed = false);

/** \p count points at equal arc length. Open: both ends kept. Closed: starts at the first point and never repeats it. */
Polyline resampled(const Polyline& line, std::size_t count, bool closed = false);

/** How a polyline is smoothed. Lengths in the unit of the points. */
struct TaubinOptions {
  double wavelength = 10.0;        ///< waves of this length keep half their height; shorter ones vanish
  double lambda = 0.5;             ///< share of the way to the middle of the neighbours, in (0, 1]
  double mu = -0.53;               ///< the same for the way back; at most -lambda
  bool closed = false;             ///< the last point is joined to the first
  std::vector<std::size_t> pinned; ///< points kept exactly, such as corners; the smoothing does not act across them
  unsigned int threads = 0;        ///< 0: as many as a ThreadLimit leaves, or all; the result does not depend on it
};

/** Taubin smoothing (Taubin 1995, lambda | mu): p += lambda L p, then p += mu L p, with L p the middle of the neighbours minus
 *  p. For lines of the published chain and of the harmonic field; the curvatures of equation (12) are another method of his.
 *
 *  The cut-off is a length and does not depend on the spacing of the points. The line is sampled at equal lengths d.
 * The neighbours are M samples away on each side so that 2 pi M d / wavelength = 1. The number of passes N is the one
 * that brings the gain at the wavelength nearest to 1/2 (16 with the default lambda and mu). A
 * pass has the gain f(k) = (1 - lambda k)(1 - mu k), k = 1 - cos(2 pi M d / w) on a wave of length w. Two
 * passes at each of the strides 1 .. M/4, M/2 come first and remove the waves of length M d / j that the last
 * stride does not reach. Gains by default: 0.02 % or less at and below wavelength / 2, 0.50 at the wavelength,
 * 0.996 at twice, 1.014 at three times (the maximum), then decreasing to 1. The smoothed line is read at the arc
 * lengths of the given points.
 *
 *  It moves a curve of radius r outwards by N |lambda + mu| (wavelength / 2 pi)^2 / (2 r): 0.006 mm at r = 100 and a
 *  wavelength of 10, by default. mu = -lambda does not move it, with a softer cut-off (0.95 at twice the wavelength).
 *
 *  Ends of an open line and pinned points do not move. Near them the line is continued by its point
 * reflection. A wavelength below two mean spacings changes nothing: the points cannot show shorter waves.
 *  \throws std::invalid_argument if an option is out of range or the wavelength lies in the pass band of
 * lambda, mu. */
Polyline taubinSmoothed(const Polyline& line, const TaubinOptions& options);

/** Gain of taubinSmoothed on a small wave of length \p wave_length across a straight line of points \p
 * spacing apart: the transfer function, far from fixed points. */
double taubinGain(double wave_length, double spacing, const TaubinOptions& options);

} // namespace pcl_spiral
