// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the smoothing of a scan moved.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/surface/surface.h>
#include <pcl_spiral/verify/figures.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** The points of a raw scan beside the surface of its smoothed copy. Lengths in mm.
 *
 *  Noise moves single points to both sides; what smoothing took of the shape moves neighbouring points to the same side. So the mean of
 *  neighbouring points tells what was lost. */
struct RawScanReport {
  static constexpr int mean_of = 25; ///< neighbouring points in a mean: the noise of a mean is a fifth of that of a point

  std::size_t points = 0;              ///< that have a surface near them
  std::size_t beside = 0;              ///< that have none
  double noise = 0.0;                  ///< standard deviation of the points about their means, from the median of their distances
  double fit_error = 0.0;              ///< of the smoothed surface: a mean of less tells nothing
  double p99 = 0.0;                    ///< 99 % of the points were moved by less
  PlacedValue largest;                 ///< the point that was moved most; its index in the raw scan
  PlacedValue mean;                    ///< the largest mean of neighbouring points, and its place; its index in the raw scan
  std::vector<Eigen::Vector3f> means;  ///< of each of the points: its place on the raw surface, by the mean of its neighbours
  std::vector<Eigen::Vector3f> others; ///< points that have no surface near them, or lie beyond its rim, as they are

  /** A mean that noise alone hardly reaches: four standard deviations, above the error of the fits. */
  double leastMean() const { return 4.0 * noise / 5.0 + fit_error; }
};

/** \deprecated Use RawScanReport. */
using RawScanFigures [[deprecated("use RawScanReport")]] = RawScanReport;

/** Measures \p raw, of the same coordinates as \p smoothed; points that are not finite do not count. */
RawScanReport compareWithRaw(const Surface& smoothed, const std::vector<Eigen::Vector3f>& raw);

/** What to tell of \p figures of the raw scan \p name. */
Diagnostic smoothingText(const RawScanReport& figures, const std::string& name);

} // namespace pcl_spiral
