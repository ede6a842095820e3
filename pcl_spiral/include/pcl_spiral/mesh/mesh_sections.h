/** \file
 *  Section toolpaths on a triangle mesh.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/mesh/impl/section_settings.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/common/drive_pass.h>

namespace pcl_spiral {

/** Contacts in passes along the sections of a mesh with parallel planes, each with the surface's normal: what CutterLocation
 *  takes. The mesh's facets are flat where the part is round; the sections are those of the curved surface behind them, so the
 *  facets' error is not cut into the part. \see SurfaceMesh, MeshSettings
 *
 *  The extent across the planes is divided into equal steps no larger than the step-over, a plane in the middle of each. Lines
 *  run from face to face; they end at the mesh's boundary and go round closed parts. Rows follow each other across; the lines
 *  of one row by the nearest end. Where the section crosses a crease, the contact comes twice, with the normal of either side.
 *
 *  Source: Sun, Li, Li, Liu, High precision and fast generation algorithm of NC tool path for triangular mesh surface, Trans.
 *  CSAM 41(7), 2010, 223-226: sections, parabolas of edges (MeshEdges::Published), R*-tree (MeshSearch::RTree). Lengths in mm,
 *  angles in degrees. The output does not depend on the search nor on the number of threads.
 */
class MeshSections {
public:
  /** The mesh, of which a SurfaceMesh is made at every compute by the settings below; faces counter-clockwise seen from
   *  outside the material. */
  void setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh);
  /** One that is there already: its own settings hold. */
  void setInputMesh(const SurfaceMesh::ConstPtr& mesh);
  /** What the last compute worked on; null before. */
  SurfaceMesh::ConstPtr getSurfaceMesh() const { return surface_mesh_; }

  /** MeshNormals::Fitted by default. */
  void setNormals(MeshNormals normals) { mesh_settings_.normals = normals; }
  MeshNormals getNormals() const { return mesh_settings_.normals; }
  /** MeshEdges::Robust by default. */
  void setEdges(MeshEdges edges) { mesh_settings_.edges = edges; }
  MeshEdges getEdges() const { return mesh_settings_.edges; }
  /** Edges bent by more are creases, degrees; 30 by default. */
  void setCreaseAngle(double degrees) { mesh_settings_.crease_angle = degrees; }
  double getCreaseAngle() const { return mesh_settings_.crease_angle; }
  /** Whether the material lies on the other side of the faces. */
  void setFlipNormals(bool flip) { mesh_settings_.flip = flip; }
  bool getFlipNormals() const { return mesh_settings_.flip; }

  /** Normal of the planes, of any length but 0; +Y by default. Rows follow each other along it. */
  void setPlaneNormal(const Eigen::Vector3d& normal) { settings_.plane_normal = normal; }
  const Eigen::Vector3d& getPlaneNormal() const { return settings_.plane_normal; }

  /** Largest distance of neighbouring planes, mm. Must be set, or the levels, but for kept rows. For a ball of radius r that leaves ridges of H on
   *  a plane: D = 2 sqrt((2 r - H) H), equation (4). */
  void setStepOver(double step) { settings_.step_over = step; }
  double getStepOver() const { return settings_.step_over; }

  /** DriveRows::Even by default. DriveRows::Kept: each plane as far from the next as the ball of setScallop leaves no higher ridge
   *  anywhere between, by slope and curvature; as few planes as that takes, and the step-over does not count. Steps are held at a
   *  quarter of (4), with a warning where less is asked for, as on walls along the planes. \see rowDistance, rowLevels */
  void setRows(DriveRows rows) { settings_.rows = rows; }
  DriveRows getRows() const { return settings_.rows; }
  /** Ball and ridge \p height that rows are kept for, mm. Must be set for DriveRows::Kept. */
  void
  setScallop(double radius, double height)
  {
    settings_.tool_radius = radius;
    settings_.scallop_height = height;
  }
  double getToolRadius() const { return settings_.tool_radius; }
  double getScallopHeight() const { return settings_.scallop_height; }

  /** Whether rows run to and fro are joined on the surface, to one pass, where the next begins within two step-overs of the end of
   *  this one and the straight way between is over the mesh; false by default. */
  void setLinkRows(bool link) { settings_.link_rows = link; }
  bool getLinkRows() const { return settings_.link_rows; }

  /** Planes at these distances from the origin along the normal, mm, ascending, in place of those by the step-over. */
  void setLevels(std::vector<double> levels) { settings_.levels = std::move(levels); }
  const std::vector<double>& getLevels() const { return settings_.levels; }

  /** Points are put inside faces until straight moves stay this near the curved surface, mm; 0.005 by default. */
  void setChordError(double error) { settings_.chord_error = error; }
  double getChordError() const { return settings_.chord_error; }

  /** Largest distance of consecutive contacts, mm; 0, the default: as the chord error asks. */
  void setPointSpacing(double spacing) { settings_.point_spacing = spacing; }
  double getPointSpacing() const { return settings_.point_spacing; }

  /** Whether every other row is run backwards; true by default. */
  void setZigzag(bool zigzag) { settings_.zigzag = zigzag; }
  bool getZigzag() const { return settings_.zigzag; }

  /** Tool axis of all contacts, from the tip to the shank; +Z by default. */
  void setAxis(const Eigen::Vector3d& axis) { settings_.axis = axis; }
  const Eigen::Vector3d& getAxis() const { return settings_.axis; }

  /** Whether to leave out contacts whose normal leans away from the tool axis by more than 90 degrees, as on the lower side of a
   *  solid: no cutter reaches them along that axis. Passes are cut there; false by default. */
  void setFacing(bool facing) { settings_.facing = facing; }
  bool getFacing() const { return settings_.facing; }

  /** MeshSearch::LevelLines by default. */
  void setSearch(MeshSearch search) { settings_.search = search; }
  MeshSearch getSearch() const { return settings_.search; }

  /** Threads to use; 0, the default, means all. */
  void setNumberOfThreads(unsigned int threads = 0) { number_of_threads_ = threads; }
  unsigned int getNumberOfThreads() const { return number_of_threads_; }

  /** Whether compute leaves the console alone where it fails; false by default. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; }

  /** Called with the share done; returning false cancels. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Make the passes. \p passes is empty on failure: no mesh, or one without points, faces or area, an index that is no
   *  point's, a corner that is not finite; a setting out of range; no plane that crosses the mesh; passes larger than memory;
   *  or cancelled. */
  void compute(DrivePasses& passes);

  const Status& getStatus() const { return status_; }
  const SectionReport& getReport() const { return report_; }

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
