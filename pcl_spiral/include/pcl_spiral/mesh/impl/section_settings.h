// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings of section passes over a mesh, and their report.
 */
#pragma once

#include <pcl_spiral/common/impl/drive_rows.h>
#include <pcl_spiral/common/status.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

/** How to find the faces that a plane crosses. All give the same lines. */
enum class MeshSearch {
  LevelLines, ///< all planes at once, face by face
  RTree,      ///< plane by plane, with an R*-tree of the boxes of the faces, as published
  AllFaces    ///< plane by plane, with a loop over all faces
};

/** Settings of section passes. Lengths in mm. */
struct SectionSettings {
  Eigen::Vector3d plane_normal = Eigen::Vector3d::UnitY();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ(); ///< of the tool, from the tip to the shank
  double step_over = 0.0;                          ///< largest distance between neighbouring planes
  DriveRows rows = DriveRows::Even;
  double tool_radius = 0.0, scallop_height = 0.0; ///< of the ball, for DriveRows::Kept
  bool link_rows = false;
  bool facing = false;        ///< leave out what faces away from the tool axis
  std::vector<double> levels; ///< distances of the planes from the origin along the normal, ascending; empty: by the step-over
  double chord_error = 0.005; ///< straight moves stay this near the curved surface
  double point_spacing = 0.0; ///< largest distance between consecutive contacts; 0: none
  bool zigzag = true;
  MeshSearch search = MeshSearch::LevelLines;
};

/** Checks the settings; ok if nothing is wrong. */
Status checkSettings(const SectionSettings& settings);

/** Report of section passes. */
struct SectionReport {
  std::size_t rows = 0; ///< planes that cross the mesh
  std::size_t passes = 0, points = 0;
  std::size_t crossings = 0;                   ///< of planes with edges
  std::size_t inside_points = 0;               ///< added inside faces, for the chord error
  double step_over = 0.0, smallest_step = 0.0; ///< largest and smallest distance between neighbouring planes, mm
  double held_share = 0.0;     ///< share of the surface that would need rows closer than DriveRows::Kept puts them; MeshSections::setRows
  std::size_t facing_away = 0; ///< contacts left out, see MeshSections::setFacing
  std::size_t links = 0;       ///< rows joined on the surface
  std::size_t rows_apart = 0;  ///< passes of rows that could not be joined to the row before
  double length = 0.0;         ///< of all passes, mm
  std::vector<std::string> warnings;
};

} // namespace pcl_spiral
