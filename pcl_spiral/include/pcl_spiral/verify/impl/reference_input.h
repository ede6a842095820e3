/** \file
 *  What the classes that judge a path have in common: the scan or the mesh it is judged by.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/surface/surface_input.h>
#include <pcl_spiral/verify/impl/cutter_path.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <pcl/pcl_base.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>

namespace pcl_spiral {

/** Takes a reference (a cloud or a surface, see SurfaceInput, or a mesh) and a toolpath. Base of DeviationEstimation and MaterialRemoval.
 *
 *  The planner's own surface may be given (setInputSurface), which spares making one: its points are cleaned and oriented as
 *  the planner's, but the fit that judges is another one, see ReferenceSurface. */
template <typename PointT>
class ReferenceInput : public SurfaceInput<pcl::PCLBase<PointT>, PointT> {
public:
  using ToolpathConstPtr = pcl::PointCloud<ToolpathPoint>::ConstPtr;

  ReferenceInput() { this->scanned_.setStrict(false); } // a rough reference is judged by all the same, with a warning

  /** Judge by samples of this mesh's curved surface; see ReferenceMesh and ReferenceSurface. Its faces tell the side: no view
   *  point, nor what else belongs to scans, may be set. What is set last of cloud, surface and mesh counts. */
  void
  setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh)
  {
    forget();
    polygons_ = mesh;
  }
  void
  setInputMesh(const SurfaceMesh::ConstPtr& mesh)
  {
    forget();
    mesh_ = mesh;
  }
  /** The mesh made ready, as given or after compute; null without one. */
  SurfaceMesh::ConstPtr getSurfaceMesh() const { return mesh_; }

  /** How a PolygonMesh is made ready: creases, normals, side. */
  void setMeshSettings(const MeshSettings& settings) { mesh_settings_ = settings; }
  const MeshSettings& getMeshSettings() const { return mesh_settings_; }

  /** Distance of the samples of a mesh, mm; 0, the default: defaultSampleSpacing. */
  void setSampleSpacing(double spacing) { sample_spacing_ = spacing; }
  double getSampleSpacing() const { return sample_spacing_; }

  /** The path to judge. Its points carry contact and normal; the axis is used where there is one. \p passes: where its second
   *  pass begins, and each further one, to which the tool is lifted and cuts nothing on the way; empty, the default: where the arc
   *  length stands still, see passBegins. */
  void
  setInputToolpath(const ToolpathConstPtr& toolpath, std::vector<std::size_t> passes = {})
  {
    toolpath_ = toolpath;
    passes_ = std::move(passes);
  }
  ToolpathConstPtr getInputToolpath() const { return toolpath_; }
  const std::vector<std::size_t>& getPasses() const { return passes_; }

  /** Chord error asked of the path, mm, compared with the noise; 0.005 by default. */
  void setChordError(double error) { chord_error_ = error; }
  double getChordError() const { return chord_error_; }

  /** Called with the share done; returning false cancels. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Judge by a fit made before, of the same cloud or surface: saves making it twice. \see getReferenceSurface. A null
   *  pointer, the default: make it at every compute. setInputCloud, setInputSurface and setInputMesh forget it. Of a closed mesh the
   *  fit is that of the faces its path touched. */
  void setReferenceSurface(const std::shared_ptr<const ReferenceSurface>& surface) { given_reference_ = surface; }
  /** The fit of the last compute; null before. */
  std::shared_ptr<const ReferenceSurface> getReferenceSurface() const { return reference_; }

  void
  setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    forget();
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputCloud(cloud);
  }
  /** \see SurfaceInput::setInputSurface */
  void
  setInputSurface(const Surface::ConstPtr& surface)
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputSurface(surface);
    given_reference_.reset();
    polygons_.reset();
    mesh_.reset();
  }

protected:
  /** Read the path and make the surface. */
  Status prepare(CutterPath& path);
  Status prepareMesh(const CutterPath& path);
  /** Whatever reference was given. */
  void
  forget()
  {
    this->input_.reset();
    this->given_surface_.reset();
    given_reference_.reset();
    polygons_.reset();
    mesh_.reset();
  }

  ToolpathConstPtr toolpath_;
  std::vector<std::size_t> passes_;
  pcl::PolygonMesh::ConstPtr polygons_;
  SurfaceMesh::ConstPtr mesh_;
  MeshSettings mesh_settings_;
  double sample_spacing_ = 0.0;
  double chord_error_ = 0.005;
  ProgressCallback progress_;
  std::shared_ptr<const ReferenceSurface> given_reference_, reference_;
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/reference_input.hpp>
