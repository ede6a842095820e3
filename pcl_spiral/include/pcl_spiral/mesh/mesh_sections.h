// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Section toolpaths on a triangle mesh.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <Eigen/Core>

#include <cstddef>
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
  Eigen::Vector3d plane_normal = Eigen::Vector3d::UnitY(); ///< of the planes; any length except 0
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();         ///< of the tool, from the tip to the shank
  double step_over = 0.0;                                  ///< largest distance between neighbouring planes
  DriveRows rows = DriveRows::Even;                        ///< how planes are spaced
  double tool_radius = 0.0;                                ///< of the ball, for DriveRows::Kept
  double scallop_height = 0.0;                             ///< for DriveRows::Kept
  bool link_rows = false;                                  ///< join rows on the surface
  bool facing = false;                                     ///< leave out what faces away from the tool axis
  std::vector<double> levels; ///< distances of the planes from the origin along the normal, ascending; empty: by the step-over
  double chord_error = 0.005; ///< straight moves stay this near the curved surface
  double point_spacing = 0.0; ///< largest distance between consecutive contacts; 0: none
  bool zigzag = true;         ///< every second row runs backwards
  MeshSearch search = MeshSearch::LevelLines; ///< how the faces that a plane crosses are found
};

/** Checks the settings; ok if nothing is wrong. */
Status checkSettings(const SectionSettings& settings);

/** Report of section passes. */
struct SectionReport {
  std::size_t rows = 0;          ///< planes that cross the mesh
  std::size_t passes = 0;        ///< unbroken lines
  std::size_t points = 0;        ///< contacts of all passes
  std::size_t crossings = 0;     ///< of planes with edges
  std::size_t inside_points = 0; ///< added inside faces, for the chord error
  double step_over = 0.0;        ///< largest distance between neighbouring planes, mm
  double smallest_step = 0.0;    ///< the smallest, mm
  double held_share = 0.0;       ///< share of the surface that would need rows closer than DriveRows::Kept puts them; MeshSections::setRows
  std::size_t facing_away = 0;   ///< contacts left out, see MeshSections::setFacing
  std::size_t links = 0;         ///< rows joined on the surface
  std::size_t rows_apart = 0;    ///< passes of rows that could not be joined to the row before
  double length = 0.0;           ///< of all passes, mm
  Diagnostics warnings;          ///< in full sentences, with the remedy
};

/** Contacts in passes along the sections of a mesh with parallel planes, each with the normal of the surface, as
 *  CutterLocation takes them. The facets of the mesh are flat where the part is round. The sections are those of the
 *  curved surface behind them, so the error of the facets is not cut into the part. \see SurfaceMesh, MeshSettings
 *
 *  The extent across the planes is divided into equal steps no larger than the step-over, with a
 *  plane in the middle of each. Lines run from face to face; they end at the boundary of the mesh
 *  and go round closed parts. Rows are ordered across; the lines of one row by the nearest end.
 *  Where a section crosses a crease, the contact comes twice, with the normal of either side.
 *
 *  Source: Sun, Li, Li, Liu, High precision and fast generation algorithm of NC tool path for triangular mesh surface,
 *  Trans. CSAM 41(7), 2010, 223-226: sections, parabolas of edges (MeshEdges::Published), R*-tree (MeshSearch::RTree).
 *  Lengths in mm, angles in degrees. The output does not depend on the search or on the number of threads. */
class MeshSections {
public:
  /** The mesh. Every compute makes a SurfaceMesh of it by the settings
   *  below. Faces are counter-clockwise, seen from outside the material. */
  void setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh);
  /** A SurfaceMesh made earlier: its own settings are used. */
  void setInputMesh(const SurfaceMesh::ConstPtr& mesh);
  /** The mesh of the last compute; null before. */
  SurfaceMesh::ConstPtr getSurfaceMesh() const { return surface_mesh_; }

  /** How vertex normals are found; MeshNormals::Fitted by default. */
  void setNormals(MeshNormals normals) { mesh_settings_.normals = normals; }
  MeshNormals getNormals() const { return mesh_settings_.normals; } ///< The value of setNormals.
  /** How edges are bent; MeshEdges::Robust by default. */
  void setEdges(MeshEdges edges) { mesh_settings_.edges = edges; }
  MeshEdges getEdges() const { return mesh_settings_.edges; } ///< The value of setEdges.
  /** Edges bent by more than this are creases, degrees; 30 by default. */
  void setCreaseAngle(double degrees) { mesh_settings_.crease_angle = degrees; }
  double getCreaseAngle() const { return mesh_settings_.crease_angle; } ///< The value of setCreaseAngle.
  /** Whether the material is on the other side of the faces; false by default. */
  void setFlipNormals(bool flip) { mesh_settings_.flip = flip; }
  bool getFlipNormals() const { return mesh_settings_.flip; } ///< The value of setFlipNormals.

  /** Normal of the planes, of any length except 0; +Y by default. Rows are ordered along it. */
  void setPlaneNormal(const Eigen::Vector3d& normal) { settings_.plane_normal = normal; }
  const Eigen::Vector3d& getPlaneNormal() const { return settings_.plane_normal; } ///< The value of setPlaneNormal.

  /** Largest distance between neighbouring planes, mm. Must be set, except with levels or DriveRows::Kept. For
   *  a ball of radius r that leaves ridges of height H on a plane: D = 2 sqrt((2 r - H) H), equation (4). */
  void setStepOver(double step) { settings_.step_over = step; }
  double getStepOver() const { return settings_.step_over; } ///< The value of setStepOver.

  /** How planes are spaced; DriveRows::Even by default. DriveRows::Kept: as few planes as possible, so that the ball leaves
   *  no ridge above the scallop height between two planes, from slope and curvature. The step-over has no effect. Steps never go below
   *  a quarter of (4); a warning reports where less would be needed, as on walls along the planes. \see rowDistance, rowLevels */
  void setRows(DriveRows rows) { settings_.rows = rows; }
  DriveRows getRows() const { return settings_.rows; } ///< The value of setRows.
  /** Radius of the ball for DriveRows::Kept, mm. Must be set for it. */
  void setToolRadius(double radius) { settings_.tool_radius = radius; }
  double getToolRadius() const { return settings_.tool_radius; } ///< The value of setToolRadius.
  /** Scallop height for DriveRows::Kept, mm. Must be set for it. */
  void setScallopHeight(double height) { settings_.scallop_height = height; }
  double getScallopHeight() const { return settings_.scallop_height; } ///< The value of setScallopHeight.
  /** \deprecated Use setToolRadius and setScallopHeight. */
  [[deprecated("use setToolRadius and setScallopHeight")]] void setScallop(double radius, double height)
  {
    setToolRadius(radius), setScallopHeight(height);
  }

  /** Whether rows in zigzag are joined on the surface to one pass. This is done if the next row begins within
   *  two step-overs of the end of this row, and the straight way between is over the mesh. False by default. */
  void setLinkRows(bool link) { settings_.link_rows = link; }
  bool getLinkRows() const { return settings_.link_rows; } ///< The value of setLinkRows.

  /** Planes at these distances from the origin along the normal, mm, ascending; used instead of the step-over. */
  void setLevels(std::vector<double> levels) { settings_.levels = std::move(levels); }
  const std::vector<double>& getLevels() const { return settings_.levels; } ///< The value of setLevels.

  /** Points are added inside faces until straight moves stay this near the curved surface, mm; 0.005 by default. */
  void setChordError(double error) { settings_.chord_error = error; }
  double getChordError() const { return settings_.chord_error; } ///< The value of setChordError.

  /** Largest distance between consecutive contacts, mm; 0, the default: set by the chord error. */
  void setPointSpacing(double spacing) { settings_.point_spacing = spacing; }
  double getPointSpacing() const { return settings_.point_spacing; } ///< The value of setPointSpacing.

  /** Whether every second row runs backwards; true by default. */
  void setZigzag(bool zigzag) { settings_.zigzag = zigzag; }
  bool getZigzag() const { return settings_.zigzag; } ///< The value of setZigzag.

  /** Tool axis of all contacts, from the tip to the shank; +Z by default. */
  void setAxis(const Eigen::Vector3d& axis) { settings_.axis = axis; }
  const Eigen::Vector3d& getAxis() const { return settings_.axis; } ///< The value of setAxis.

  /** Whether to leave out contacts whose normal leans away from the tool axis by more than 90 degrees, as on the
   *  lower side of a solid: no cutter reaches them along that axis. Passes are cut there; false by default. */
  void setFacing(bool facing) { settings_.facing = facing; }
  bool getFacing() const { return settings_.facing; } ///< The value of setFacing.

  /** How the faces that a plane crosses are found; MeshSearch::LevelLines by default. */
  void setSearch(MeshSearch search) { settings_.search = search; }
  MeshSearch getSearch() const { return settings_.search; } ///< The value of setSearch.

  /** Number of threads; 0, the default: all. */
  void setNumberOfThreads(unsigned int threads = 0) { number_of_threads_ = threads; }
  unsigned int getNumberOfThreads() const { return number_of_threads_; } ///< The value of setNumberOfThreads.

  /** Whether compute prints no message on failure; false by default. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.

  /** Called with the completed share; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Computes the passes. \p passes is empty on failure: no mesh, or one without points, faces
   *  or area; an index that is not one of a point; a corner that is not finite; a setting out
   *  of range; no plane that crosses the mesh; passes larger than memory; or cancelled. */
  void compute(DrivePasses& passes);

  const Status& getStatus() const { return status_; }        ///< Result of the last compute.
  const SectionReport& getReport() const { return report_; } ///< Figures and warnings of the last compute.

private:
  Status run(DrivePasses& passes);

  pcl::PolygonMesh::ConstPtr input_;
  SurfaceMesh::ConstPtr given_mesh_, surface_mesh_;
  MeshSettings mesh_settings_;
  SectionSettings settings_;
  unsigned int number_of_threads_ = 0;
  bool quiet_ = false;
  ProgressCallback progress_;
  Status status_;
  SectionReport report_;
};

} // namespace pcl_spiral
