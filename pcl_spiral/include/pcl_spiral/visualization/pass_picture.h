// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pictures of a path of several passes, and of the rotary axes along its program, made without a window.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/machine/machine_program.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

namespace pcl_spiral {

/** Contents of the picture; lengths in mm. */
struct PassScene {
  std::string title;                              ///< such as the name of the part
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< of the part
  SurfaceMesh::ConstPtr mesh;                     ///< used instead of the cloud; null: the points of the cloud are triangulated
  /** Contacts with normals, in travel order. Turn: the number of the pass from 0, or the turns of a single pass
   *  with several turns. The arc length does not grow where the tool is lifted to the next pass, see passBegins. */
  pcl::PointCloud<ToolpathPoint>::ConstPtr path;
  CutterShape cutter;     ///< of radius 0: a beam
  double step_over = 0.0; ///< between neighbouring passes; 0: no neighbours
};

/** The passes on the shaded part, coloured by their numbers, with as many as can be seen separately in
 *  the picture (the legend shows how many). Start and end are marked, and both are enlarged with every
 *  pass. A PNG of 1600 x 1200; the same scene gives the same bytes.
 *  \throw std::runtime_error without a display, FileError if the file cannot be written, std::invalid_argument without a part or a path */
void writePasses(const std::string& file, const PassScene& scene);

/** Angles of both rotary axes and the share of the feed along the length of the path. Marks
 *  show where the tool axis was blended at the pole and where the first axis unwinds. A
 *  PNG of 1600 x 1200. \throw std::runtime_error without a display, FileError if the file
 *  cannot be written, std::invalid_argument for a program without cutting blocks */
void writeRotaryAngles(const std::string& file, const std::string& title, const MachineProgram& program);

} // namespace pcl_spiral
