/** \file
 *  Five-axis gouge-free cutter locations from a cloud or a mesh.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/surface/surface_input.h>
#include <pcl_spiral/cutter/impl/cutter_locator.h>
#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/cutter/impl/location_bisection.h>
#include <pcl_spiral/cutter/impl/location_mesh.h>

#include <pcl/PolygonMesh.h>
#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>
#include <vector>

namespace pcl_spiral {

/** Where a cutter of any profile stands on a scan without cutting into it: for each drive point, the highest
 * place along the axis at which a point within the cutter's reach, or the surface fitted to the points, is
 * touched.
 *
 *  Takes a cloud or a surface, see SurfaceInput. The cutter stays off every finite point, those left out of the surface too.
 *  A cloud of which no surface can be made may still be located on by its points (Evaluation::Points). Or takes a mesh: the
 *  cutter stays off all its faces, or the curved surface they stand for: exactly on flat triangles, to a hundredth of the
 *  contact tolerance, and 1e-4 mm, on curved ones.
 *  Source: Sun, Cui, Kang, Wang, five-axis NC toolpath generation from scattered points. Lengths in mm. The output does not
 *  depend on the order of the cloud nor on the number of threads.
 */
template <typename PointT>
class CutterLocation : public SurfaceInput<pcl::PCLBase<PointT>, PointT> {
public:
  CutterLocation() { this->scanned_.setStrict(false); } // a rough surface is located on all the same
  using Ptr = pcl::shared_ptr<CutterLocation>;
  using ConstPtr = pcl::shared_ptr<const CutterLocation>;
  using Path = pcl::PointCloud<ToolpathPoint>;
  using Evaluation = LocationEvaluation;

  /** Places, axes and, where a contact is asked for, normals. */
  void
  setDrivePoints(DrivePoints points)
  {
    drive_points_ = std::move(points);
    pass_sizes_ = {drive_points_.size()};
  }
  /** The same of several passes, such as those of DrivePath; the first point of a ring is repeated at its end. */
  void setDrivePasses(const DrivePasses& passes);
  const DrivePoints&
  getDrivePoints() const
  {
    return drive_points_;
  }
  /** The same from a toolpath: its contacts, axes and normals (zero: none). */
  void setDrivePath(const Path& path);

  /** Shape of the cutter. Must be set. */
  void
  setCutter(const CutterShape& cutter)
  {
    cutter_ = cutter;
  }
  const CutterShape&
  getCutter() const
  {
    return cutter_;
  }

  /** Evaluation::FittedSurface by default. */
  void
  setEvaluation(Evaluation evaluation)
  {
    options_.evaluation = evaluation;
  }
  Evaluation
  getEvaluation() const
  {
    return options_.evaluation;
  }

  /** A contact touched within this, along the axis, is reached, mm; 0.01 by default. */
  void
  setContactTolerance(double tolerance)
  {
    options_.tolerance = tolerance;
  }
  double
  getContactTolerance() const
  {
    return options_.tolerance;
  }

  /** What stands on the cutter, from the top of its flank upwards: shank, extensions, chuck. None by default:
   * no collision is looked for. Give the cutter its flank length. */
  void
  setHolder(std::vector<ToolSegment> segments)
  {
    options_.holder = std::move(segments);
  }
  const std::vector<ToolSegment>&
  getHolder() const
  {
    return options_.holder;
  }

  /** Distance kept between holder and scan, mm; 0 by default. Less counts as a collision. */
  void
  setHolderClearance(double clearance)
  {
    options_.holder_clearance = clearance;
  }
  double
  getHolderClearance() const
  {
    return options_.holder_clearance;
  }

  /** Largest angle by which the axis may be turned where the contact asked for is not reached or the holder
   * collides, degrees, up to 90; 0, the default: the cutter is lifted. The least of six angles that helps is
   * taken, each point by itself: neighbouring axes may differ by as much. Drive points must ask for contacts: refused
   * where none has a normal. */
  void
  setMaxRetilt(double degrees)
  {
    options_.max_retilt = degrees;
  }
  double
  getMaxRetilt() const
  {
    return options_.max_retilt;
  }

  /** Put locations between those of the drive points until no straight move of the cutter cuts deeper into the
   * surface than this, mm, nor leaves more of it; 0, the default: none. \see bisectLocations */
  void
  setPathTolerance(double tolerance)
  {
    path_tolerance_ = tolerance;
  }
  double
  getPathTolerance() const
  {
    return path_tolerance_;
  }

  /** Called with the share done; returning false cancels. */
  void
  setProgressCallback(ProgressCallback callback)
  {
    progress_ = std::move(callback);
  }

  /** Locate on what the last compute of an object made of the same cloud or surface: saves making obstacles, fit and rim
   * again. Null, the default: make it at every compute. setInputCloud, setInputSurface and setInputMesh forget it. */
  void
  setLocationSurface(const std::shared_ptr<const LocationSurface>& surface)
  {
    given_location_ = surface;
  }
  /** What the last compute located on; null before, and on a mesh. */
  std::shared_ptr<const LocationSurface>
  getLocationSurface() const
  {
    return location_surface_;
  }
  void
  setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputCloud(cloud);
    forgetInputs();
  }
  /** \see SurfaceInput::setInputSurface */
  void
  setInputSurface(const Surface::ConstPtr& surface)
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputSurface(surface);
    forgetInputs();
  }
  /** Locate on a mesh, of which SurfaceMesh is made with its default settings; what is set last counts, cloud, surface or mesh.
   * Settings of clouds (normals, view point, indices, thinning and so on) must be as they are by default. With
   * Evaluation::FittedSurface the curved surface counts that the faces stand for: less the facets' own sag in hollows, more
   * of it on ridges; with Evaluation::Points the faces as they are. Cutters stay off both sides of a face. The mesh is put in
   * order by the first compute, and kept for further ones. */
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
  /** Locate. \p locations has one a drive point, in their order, and with a path tolerance those put in
   * between, cloud_index in the input cloud or the face of getInputMesh; it is empty on failure: no cloud, no finite point, no drive point or
   * one that is not finite or has no axis, a setting out of range, no surface in the points (unless Evaluation::Points), no mesh
   * or one that SurfaceMesh::make refuses, or cancelled. */
  void compute(ToolLocations& locations);
  /** The same by passes. */
  void compute(std::vector<ToolLocations>& passes);

  /** Counts, largest values and warnings of the last compute. */
  const LocationFigures&
  getFigures() const
  {
    return figures_;
  }
  /** What a path tolerance came to. */
  const BisectionFigures&
  getBisectionFigures() const
  {
    return bisection_figures_;
  }

private:
  Status check() const;
  Status makeLocationSurface();
  Status makeLocationMesh();
  Status checkBesideMesh() const;
  Status run(std::vector<ToolLocations>& passes);
  Status locate(const CutterLocator& locator, std::vector<ToolLocations>& passes);
  std::vector<ToolLocations> inPasses(const ToolLocations& locations) const;
  void
  forgetInputs()
  {
    given_location_.reset();
    on_mesh_ = false;
    polygons_.reset();
    mesh_.reset();
    location_mesh_.reset();
  }
  void
  useMesh()
  {
    this->given_surface_.reset();
    forgetInputs();
    on_mesh_ = true;
  }

  DrivePoints drive_points_; ///< of all passes
  std::vector<std::size_t> pass_sizes_;
  double path_tolerance_ = 0.0;
  CutterShape cutter_;
  LocationOptions options_;
  ProgressCallback progress_;
  std::shared_ptr<const LocationSurface> given_location_, location_surface_;
  bool on_mesh_ = false; ///< a mesh was set last
  pcl::PolygonMesh::ConstPtr polygons_;
  SurfaceMesh::ConstPtr mesh_;
  std::shared_ptr<const LocationMesh> location_mesh_;
  LocationFigures figures_;
  BisectionFigures bisection_figures_;
};

/** What is wrong with drive points: none, one that is not finite, one without an axis. */
Status checkDrivePoints(const DrivePoints& drive);

} // namespace pcl_spiral

#include <pcl_spiral/cutter/impl/cutter_location.hpp>

namespace pcl_spiral {
extern template class CutterLocation<pcl::PointXYZ>;
extern template class CutterLocation<pcl::PointXYZRGB>;
extern template class CutterLocation<pcl::PointNormal>;
} // namespace pcl_spiral
