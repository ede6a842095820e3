/** \file
 *  Pictures of a spiral toolpath, made without a window.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>
#include <string>

namespace pcl_spiral {

/** What the pictures show; lengths in mm. */
struct PictureScene {
  std::string title; ///< such as the scan's name
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud;
  SurfaceMesh::ConstPtr mesh; ///< in place of the cloud, whose points are triangulated where there is none
  pcl::PointCloud<ToolpathPoint>::ConstPtr path;
  SpiralSettings settings;
  SpiralReport report;
};

/** What is wrong with the X display that VTK draws through: "DISPLAY is not set"; empty where nothing is. */
std::string displayFault();

/** Why no picture can be made here, and the remedy; empty where one can. VTK draws through an X display. */
std::string displayProblem();

struct DisplaySurface;

/** The pictures of one scene, each a PNG of 1600 x 1200. */
class SpiralPictures {
public:
  /** Thins and triangulates the cloud for drawing; a mesh is drawn with its own triangles. */
  explicit SpiralPictures(PictureScene scene);
  ~SpiralPictures();

  /** Boundary loops and radial lines over the cloud, coloured by height.
   *  \throw std::runtime_error without a display, FileError where the file cannot be written */
  void writeLines(const std::string& file) const;

  /** The spiral on the shaded surface: as many of its turns as stand apart in the picture (the legend says
   * which), start and end marked, and both enlarged with every turn. Errors as for writeLines. */
  void writeSpiral(const std::string& file) const;

private:
  PictureScene scene_;
  std::unique_ptr<DisplaySurface> surface_;
};

} // namespace pcl_spiral
