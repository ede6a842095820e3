// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The points of a scan beside a rail, in the coordinates of its frames.
 */
#pragma once

#include "station_line.h"

#include <pcl_spiral/core/impl/ridge_frame.h>
#include <pcl_spiral/surface/surface.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** A point of the band of a ridge. */
struct BandPoint {
  Eigen::Vector3d place;
  std::uint32_t station = 0;                       ///< station of the rail near it
  std::uint32_t profile_station = 0;               ///< station of the generator near it
  double u = 0.0;                                  ///< arc length of its foot on the rail
  Eigen::Vector3d local = Eigen::Vector3d::Zero(); ///< along tangent, chord and up
  bool inside = false;                             ///< beside the rail, not beyond its ends
};

/** Rail, chord and points. */
struct SectionBand {
  SmoothLine rail;
  RidgeChord chord;
  std::vector<BandPoint> points;
};

/** The points of \p surface within \p reach of the rail, on that side of it. */
std::vector<BandPoint> bandPoints(const Surface& surface, const StationLine& rail, double reach);

/** Compute the coordinates of all points again from the band's rail and chord. */
void placePoints(const StationLine& rail, SectionBand& band);

/** Points sorted into \p count sections of \p length about stations of the rail: indices, and where each section begins among them. */
struct SectionPoints {
  std::vector<std::uint32_t> order, begin;
};
SectionPoints pointsBySection(const SectionBand& band, std::size_t count, double length);

} // namespace pcl_spiral
