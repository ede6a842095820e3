/** \file
 *  Pictures of a ridge of which two lines were measured, made without a window.
 */
#pragma once

#include <pcl_spiral/ridge/ridge_surface.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

namespace pcl_spiral {

/** What the pictures show; lengths in mm. */
struct RidgeScene {
  std::string title; ///< such as the part's name
  RidgeSurface::ConstPtr ridge;
  Polyline rail, generator; ///< the measured points
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr scan; ///< of the part, drawn behind the lines; null: there is none
};

/** Both measured lines on the shaded ridge, their fitted curves, and the frame m1, m2, m3 that carries the generator at stations of
 *  the rail; the generator enlarged in the rail's normal plane where they meet, and what was found of it all (RidgeReport). A PNG
 *  of 1600 x 1200; the same scene gives the same bytes.
 *  \throw std::runtime_error without a display, FileError where the file cannot be written, std::invalid_argument without a ridge or
 *  its lines */
void writeRidgeLines(const std::string& file, const RidgeScene& scene);

/** The ridge coloured by the angle between the published normal (RidgeNormals::InNormalPlane) and the true one; both normals where it
 *  is largest, and the angle over the generator. Needs no measured points. Errors as for writeRidgeLines. */
void writeRidgeNormals(const std::string& file, const RidgeScene& scene);

} // namespace pcl_spiral
