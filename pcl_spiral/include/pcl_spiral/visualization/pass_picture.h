/** \file
 *  A picture of a path of several passes, made without a window.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

namespace pcl_spiral {

/** What the picture shows; lengths in mm. */
struct PassScene {
  std::string title; ///< such as the part's name
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;
  SurfaceMesh::ConstPtr mesh; ///< in place of the cloud; null: the cloud's points are triangulated
  /** Contacts with normals, in travel order. Turn: the number of the pass from 0, or in a single pass of several turns the
   *  turns; the arc length does not grow where the tool is lifted to the next pass, see passBegins. */
  pcl::PointCloud<ToolpathPoint>::ConstPtr path;
  CutterShape cutter;     ///< of radius 0: a beam
  double step_over = 0.0; ///< of neighbouring passes; 0: there are none
};

/** The passes on the shaded part, coloured by their numbers: as many as stand apart in the picture (the legend says how many),
 *  start and end marked, and both enlarged with every pass. A PNG of 1600 x 1200; the same scene gives the same bytes.
 *  \throw std::runtime_error without a display, FileError where the file cannot be written, std::invalid_argument without a
 *  part or a path */
void writePasses(const std::string& file, const PassScene& scene);

} // namespace pcl_spiral
