/** \file
 *  Places and axes that drive a cutter over a scan or a mesh.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/surface/surface_input.h>
#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/drive/drive_settings.h>

#include <pcl/PolygonMesh.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace pcl_spiral {

/** Drive points in passes over a scan, with tool axes and without normals: each is a line along which
 * CutterLocation brings the cutter down until it touches. The spiral of SpiralToolpathGenerator is another
 * such path: see CutterLocation::setDrivePath.
 *
 *  - DriveKind::Planes: the triangulated scan is cut by planes that hold the tool axis and the direction of
 * the passes. The extent across is divided into equal steps no larger than the step-over, a plane in the
 * middle of each. Gaps wider than three spacings of the scan cut a pass in two. Where one part hides another
 * from the tool, both are cut: CutterLocation then lifts the cutter from the lower onto the upper.
 *  - DriveKind::Helix, Rings: on the cylinder of the scan's mean radius about the axis of the drive cylinder,
 * given or fitted. The extent along the axis is divided likewise; the helix climbs one step a turn from the
 * middle of the first to that of the last, with a ring at both ends.
 *  - DriveKind::Curve: a curve at equal steps of arc length.
 *  - DriveKind::BoundaryOffset: lines of equal distance along the surface from its outer boundary. The
 * greatest distance is divided likewise; outermost first, the boundary on their right. Where an island ends
 * more than half a step inside its last line, one more runs half a step from its peak. A hole cuts them; so
 * does a rim more jagged than half a step, of which a warning is given.
 *
 *  No place of the surface is farther from a pass than half a step-over, across the passes: as projected
 * along the tool axis for planes, along the cylinder's axis, or along the surface for offsets.
 *
 *  Takes a cloud or a surface, see SurfaceInput; a curve whose axis is fixed needs neither. Source of
 * planes and cylinder: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points. Lengths
 * in mm, angles in degrees. The output does not depend on the order of the cloud nor on the number of
 * threads.
 */
template <typename PointT>
class DrivePath : public SurfaceInput<pcl::PCLBase<PointT>, PointT> {
public:
  DrivePath() { this->scanned_.setStrict(false); } // a rough surface is driven on all the same, with a warning

  /** Drive over a mesh, of which SurfaceMesh is made with its default settings; what is set last counts, cloud, surface or mesh.
   *  Planes are its sections (MeshSections): contacts with normals, on the curved surface behind the faces; with AxisMode::Fixed
   *  what faces away from the axis is left out. Helix, rings and curves are as on a cloud, of points of the mesh (MeshSampling).
   *  Kind::BoundaryOffset is refused. Settings of clouds (normals, view point, thinning and so on) must be as they are by
   *  default. */
  void
  setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh)
  {
    useMesh();
    polygons_ = mesh;
  }
  /** The same, made with settings of one's own. */
  void
  setInputMesh(const SurfaceMesh::ConstPtr& mesh)
  {
    useMesh();
    mesh_ = mesh;
  }
  /** The mesh given, or made by the last compute of the polygons given; null before, and of clouds. */
  SurfaceMesh::ConstPtr
  getInputMesh() const
  {
    return mesh_;
  }
  void
  setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputCloud(cloud);
    forgetMesh();
  }
  /** \see SurfaceInput::setInputSurface */
  void
  setInputSurface(const Surface::ConstPtr& surface)
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputSurface(surface);
    forgetMesh();
  }

  using Ptr = pcl::shared_ptr<DrivePath>;
  using ConstPtr = pcl::shared_ptr<const DrivePath>;
  using Kind = DriveKind;
  using AxisMode = DriveAxisMode;
  using Rows = DriveRows;

  /** Kind::Planes by default. */
  void
  setKind(DriveKind kind)
  {
    settings_.kind = kind;
  }
  DriveKind
  getKind() const
  {
    return settings_.kind;
  }

  /** Largest distance of neighbouring planes, rings, turns or offsets, mm. Must be set, but for a curve and rows that
   * are kept, where it does not count. From the cutter's profile: stepForScallop. */
  void
  setStepOver(double step)
  {
    settings_.step_over = step;
  }
  double
  getStepOver() const
  {
    return settings_.step_over;
  }

  /** Largest distance of consecutive drive points along their pass, mm; 1 by default. */
  void
  setPointSpacing(double spacing)
  {
    settings_.point_spacing = spacing;
  }
  double
  getPointSpacing() const
  {
    return settings_.point_spacing;
  }

  /** Of sections of a mesh: straight moves stay this near the curved surface, mm; 0.005 by default. */
  void
  setChordError(double error)
  {
    settings_.chord_error = error;
  }
  double
  getChordError() const
  {
    return settings_.chord_error;
  }

  /** Direction of planes' passes: degrees about the tool axis, right-handed, from X, or from Y where the axis
   * is within 26 degrees of X. 0 by default. */
  void
  setPlaneDirection(double degrees)
  {
    settings_.plane_angle = degrees;
    settings_.plane_direction.setZero();
  }
  double
  getPlaneAngle() const
  {
    return settings_.plane_angle;
  }
  /** The same as a vector; what it has along the tool axis does not count. */
  void
  setPlaneDirection(const Eigen::Vector3d& along)
  {
    settings_.plane_direction = along;
  }
  /** Zero where the angle tells. */
  const Eigen::Vector3d&
  getPlaneDirection() const
  {
    return settings_.plane_direction;
  }

  /** DriveRows::Even by default. DriveRows::Kept, of Kind::Planes: each plane as far from the next as the ball of
   * setScallop leaves no higher ridge anywhere between, by slope and curvature of the fitted surface; as few planes as
   * that takes. Steps are held at a quarter of that on a plane, 2 sqrt((2 r - h) h), with a warning where less is asked
   * for, as on walls along the planes. Where a rim leans out across the rows, a ball dropped along a fixed axis reaches
   * it only from beyond, where no plane is. \see rowDistance, rowLevels */
  void
  setRows(DriveRows rows)
  {
    settings_.rows = rows;
  }
  DriveRows
  getRows() const
  {
    return settings_.rows;
  }
  /** Ball and ridge \p height that rows are kept for, mm. Must be set for DriveRows::Kept. */
  void
  setScallop(double radius, double height)
  {
    settings_.tool_radius = radius;
    settings_.scallop_height = height;
  }
  double
  getToolRadius() const
  {
    return settings_.tool_radius;
  }
  double
  getScallopHeight() const
  {
    return settings_.scallop_height;
  }

  /** Whether rows of planes run to and fro are joined on the surface, to one pass, where the next begins within two
   * step-overs of the end of this one and the straight way between is over the scan, across no gap; false by default. */
  void
  setLinkRows(bool link)
  {
    settings_.link_rows = link;
  }
  bool
  getLinkRows() const
  {
    return settings_.link_rows;
  }

  /** Whether every other plane, or arc of a sector, is run backwards; true by default. */
  void
  setZigzag(bool zigzag)
  {
    settings_.zigzag = zigzag;
  }
  bool
  getZigzag() const
  {
    return settings_.zigzag;
  }

  /** Tool axis, from the tip to the shank: of AxisMode::Fixed, and of section planes. +Z by default. */
  void
  setAxis(const Eigen::Vector3d& axis)
  {
    settings_.axis = axis;
  }
  const Eigen::Vector3d&
  getAxis() const
  {
    return settings_.axis;
  }

  /** Axis and extent that drive helix, rings and AxisMode::Cylinder. Not set: fitted to the scan, which must
   * be a column scanned from outside. \see findColumn */
  void
  setCylinder(const DriveCylinder& cylinder)
  {
    settings_.cylinder = cylinder;
  }
  const std::optional<DriveCylinder>&
  getCylinder() const
  {
    return settings_.cylinder;
  }

  /** How far helix and rings go on beyond both ends of the column, mm; 0 by default. Where the surface leans along the
   * column, a cutter of radius R touches it up to R sin(lean) away from its own axis: so much of an end is not reached
   * without. */
  void
  setOverrun(double overrun)
  {
    settings_.overrun = overrun;
  }
  double
  getOverrun() const
  {
    return settings_.overrun;
  }

  /** AxisMode::Cylinder by default for helix and rings, AxisMode::Fixed for the others. */
  void
  setAxisMode(DriveAxisMode mode)
  {
    settings_.axis_mode = mode;
  }
  DriveAxisMode
  getAxisMode() const
  {
    return settings_.axisMode();
  }

  /** The curve of Kind::Curve; a closed one does not repeat its first point. Points put along it at equal arc
   * length cut its corners. */
  void
  setCurve(const Polyline& curve, bool closed = false)
  {
    settings_.curve = curve;
    settings_.curve_closed = closed;
  }
  const Polyline&
  getCurve() const
  {
    return settings_.curve;
  }

  /** Called with the share done; returning false cancels. */
  void
  setProgressCallback(ProgressCallback callback)
  {
    progress_ = std::move(callback);
  }

  /** Make the passes. \p passes is empty on failure: no cloud or fewer than 50 points, a setting out of
   * range, a scan of the wrong shape, a path of more than 1e8 points or more than the memory there is, or
   * cancelled. */
  void compute(DrivePasses& passes);

  const DriveReport&
  getReport() const
  {
    return report_;
  }

private:
  Status run(DrivePasses& passes);
  Status runOnMesh(DrivePasses& passes);
  void
  forgetMesh()
  {
    on_mesh_ = false;
    polygons_.reset();
    mesh_.reset();
  }
  void
  useMesh()
  {
    this->given_surface_.reset();
    forgetMesh();
    on_mesh_ = true;
  }

  bool on_mesh_ = false; ///< a mesh was set last
  pcl::PolygonMesh::ConstPtr polygons_;
  SurfaceMesh::ConstPtr mesh_;
  DriveSettings settings_;
  ProgressCallback progress_;
  DriveReport report_;
};

} // namespace pcl_spiral

#include <pcl_spiral/drive/impl/drive_path.hpp>

namespace pcl_spiral {
extern template class DrivePath<pcl::PointXYZ>;
extern template class DrivePath<pcl::PointXYZRGB>;
extern template class DrivePath<pcl::PointNormal>;
} // namespace pcl_spiral
