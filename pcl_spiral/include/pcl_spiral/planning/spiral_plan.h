// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A spiral over the chosen part of a scan or of a mesh, with all that it was made from.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/planning/led_tool.h>
#include <pcl_spiral/planning/part_choice.h>
#include <pcl_spiral/spiral/spiral_report.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** A mesh, and the samples used to plan the path. */
struct SampledMesh {
  SurfaceMesh::ConstPtr mesh;                     ///< the parts that the path runs over
  MeshReport counts;                              ///< of the mesh as given
  double spacing = 0.0;                           ///< of the samples, mm
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< of the samples
  std::vector<std::uint32_t> faces;               ///< of the mesh as given, one per sample
};

/** One try to plan a region. A plan has all that were made, in their order; so has a failed one. */
struct PlanAttempt {
  double margin = 0.0;          ///< PartChoice::margin, mm
  double strip_width = 0.0;     ///< strips beside keep-outs narrower than this are left out, point spacings; 0: none are
  std::vector<std::size_t> cut; ///< numbers of those of these strips that are cut all the same
  Diagnostic refusal;           ///< why it gave no path, and so why the next one was made; empty: it gave one
  bool late = false;            ///< refused after turns were made, which takes as long as a path
};

/** A path, and what it was made from. Lengths in mm. */
struct SpiralPlan {
  std::string region; ///< its name; empty: the only one, or all together
  /** If there are several; path, report, clouds, echoes and warnings are then of all together, settings of the first, the rest of none. */
  std::vector<SpiralPlan> regions;

  pcl::PointCloud<ToolpathPoint>::Ptr path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(); ///< all passes; never null
  SpiralSettings settings;                                                                       ///< as used
  SpiralReport report;                                                                           ///< with the warnings of making the path
  LedTool tool;                                                                                  ///< as used
  std::vector<PlanAttempt> attempts;                                                             ///< of the region

  pcl::PointCloud<pcl::PointXYZ>::ConstPtr whole; ///< the scan, or the samples of the mesh
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr cloud; ///< those that are of the part
  pcl::PointCloud<pcl::Normal>::ConstPtr normals; ///< of the points of the part, as given; null: none
  ChosenPart part;                                ///< how it was chosen, and what is beside it
  Surface::ConstPtr surface;                      ///< of the part, if setKeepSurface asks for it, or if planning needs it; else null
  std::vector<Eigen::Vector3f> echoes;            ///< clusters that are left out as false echoes, if there is a holder to check
  SurfaceMesh::ConstPtr whole_mesh;               ///< with the parts that the path does not run over; null for a scan
  std::optional<SampledMesh> mesh;                ///< absent for a scan

  /** The box of what stands in the scan, without false echoes, for ProgramSettings::clear_box: rapids cross above it. Empty if the whole
   *  scan is the part. */
  Eigen::AlignedBox3d clearBox() const;
};

} // namespace pcl_spiral
