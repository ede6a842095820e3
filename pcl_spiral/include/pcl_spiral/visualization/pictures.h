// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Pictures of a spiral toolpath, made without a window.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/prism.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Contents of the pictures; lengths in mm. */
struct PictureScene {
  std::string title;                              ///< such as the name of the scan
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< of the part
  SurfaceMesh::ConstPtr mesh;                     ///< used instead of the cloud; if null, the points of the cloud are triangulated
  pcl::PointCloud<ToolpathPoint>::ConstPtr path;  ///< contacts in travel order
  SpiralSettings settings;                        ///< by which the path was made
  SpiralReport report;                            ///< of its making: loops, lines, figures
  std::vector<Prism> keep_outs;                   ///< drawn as lines over the part, as high as the path nearest to them
};

/** What is wrong with the X display through which VTK draws: "DISPLAY is not set"; empty if nothing is wrong. */
std::string displayFault();

/** Why no picture can be made here, and the remedy; empty if one can. VTK draws through an X display. */
std::string displayProblem();

struct DisplaySurface;

/** The pictures of one scene, each a PNG of 1600 x 1200. */
class SpiralPictures {
public:
  /** Thins and triangulates the cloud for drawing; a mesh is drawn with its own triangles. */
  explicit SpiralPictures(PictureScene scene);
  ~SpiralPictures();

  /** Boundary loops and radial lines over the cloud, coloured by height.
   *  \throw std::runtime_error without a display, FileError if the file cannot be written */
  void writeLines(const std::string& file) const;

  /** The spiral on the shaded surface, with as many turns as can be seen separately in the picture (the legend
   *  shows which). Start and end are marked, and both are enlarged with every turn. Errors as for writeLines. */
  void writeSpiral(const std::string& file) const;

private:
  PictureScene scene_;
  std::unique_ptr<DisplaySurface> surface_;
};

} // namespace pcl_spiral
