// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pictures of a ridge from two measured lines, made without a window.
 */
#pragma once

#include <pcl_spiral/ridge/ridge_surface.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

namespace pcl_spiral {

/** Contents of the pictures; lengths in mm. */
struct RidgeScene {
  std::string title;                             ///< such as the name of the part
  RidgeSurface::ConstPtr ridge;                  ///< fitted to the lines
  Polyline rail;                                 ///< the points measured along the ridge
  Polyline generator;                            ///< the points measured across it
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr scan; ///< of the part, drawn behind the lines; null: none
};

/** Both measured lines on the shaded ridge, their fitted curves, and the frame m1, m2, m3 that carries the
 *  generator, at stations of the rail. The generator is enlarged in the normal plane of the rail where they
 *  meet, with the values found (RidgeReport). A PNG of 1600 x 1200; the same scene gives the same bytes.
 *  \throw std::runtime_error without a display, FileError if the file cannot be written,
 *  std::invalid_argument without a ridge or its lines */
void writeRidgeLines(const std::string& file, const RidgeScene& scene);

/** The ridge coloured by the angle between the published normal (RidgeNormals::InNormalPlane) and the true one; both normals
 *  where it is largest, and the angle over the generator. Needs no measured points. Errors as for writeRidgeLines. */
void writeRidgeNormals(const std::string& file, const RidgeScene& scene);

} // namespace pcl_spiral
