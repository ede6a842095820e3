// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Shifts a generator onto a section.
 */
#pragma once

#include "section_band.h"

namespace pcl_spiral {

/** The generator in local coordinates; its stations continue straight beyond both ends. */
struct Profile {
  StationLine line;
  double length = 0.0; ///< without the straight extensions
};

/** The fit of the generator to one section. Sums and medians are per cell, a station of the generator. */
struct SectionShift {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< of the origin, along chord and up
  Eigen::Vector3d roll = Eigen::Vector3d::Zero();  ///< the shift needed if the section turns by one radian about the tangent
  bool found = false;                              ///< enough points, with normals that define both directions
  std::vector<float> mean, median;                 ///< distance of a cell's points from the shifted generator; the mean without far points
  std::vector<std::uint32_t> count;                ///< of points in a cell
  double squares = 0.0;                            ///< sum of squared distances of its points, within the generator's length
  std::size_t points = 0;                          ///< within the generator's length
};

/** Shift \p profile onto the points of a section by least squares along its normals (Gauss-Newton; Tukey's weights against points that
 *  do not belong to the section). Points farther than \p gate belong to another surface. \p noise: of the scan. With 0 steps
 *  the generator does not move. */
SectionShift shiftOnto(SectionBand& band, const SectionPoints& sections, std::size_t section, const Profile& profile, double noise,
                       double gate, int most_steps = 10);

} // namespace pcl_spiral
