// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A generator shifted onto a section.
 */
#pragma once

#include "ridge_band.h"

namespace pcl_spiral {

/** The generator in local coordinates; its stations beyond both ends run straight on. */
struct Profile {
  StationLine line;
  double length = 0.0; ///< without what runs straight on
};

/** How the generator lies on one section. Sums and medians by stations of the generator, cells. */
struct SectionShift {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< of the origin, along chord and up
  Eigen::Vector3d roll = Eigen::Vector3d::Zero();  ///< the shift that a section turned by one radian about the tangent asks for
  bool found = false;                              ///< enough points, whose normals tell both directions
  std::vector<float> mean, median;                 ///< off the shifted generator, of the points of a cell; mean without what lies far off
  std::vector<std::uint32_t> count;                ///< of points in a cell
  double squares = 0.0;                            ///< of what its points are off, within the generator's length
  std::size_t points = 0;                          ///< within the generator's length
};

/** Shift \p profile onto the points of a section, by least squares along its normals (Gauss-Newton; Tukey's weights, for what does not
 *  belong to the section); points farther than \p gate belong to another surface. \p noise is the scan's. Without steps
 *  the generator stays where it is. */
SectionShift shiftOnto(RidgeBand& band, const SectionPoints& sections, std::size_t section, const Profile& profile, double noise,
                       double gate, int most_steps = 10);

} // namespace pcl_spiral
