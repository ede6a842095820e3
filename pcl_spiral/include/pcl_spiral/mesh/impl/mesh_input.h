// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Input of stages that take a mesh as well as a cloud or a surface.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/surface/surface_input.h>

#include <pcl/PolygonMesh.h>
#include <pcl/pcl_base.h>

#include <string>

namespace pcl_spiral {

/** Ok, or an error if a setting for clouds is not at its default: it has no meaning for a mesh. */
inline Status
checkBesideMesh(const SurfaceSettings& settings, bool with_normals, bool with_indices)
{
  const Diagnostic setter = with_normals ? "{setInputNormals}" : with_indices ? "{setIndices}" : disagreement(settings, SurfaceSettings());
  if (setter.empty())
    return Status::success();
  return {StatusCode::InvalidArgument,
          Diagnostic(setter, " was called beside {setInputMesh}, and has no meaning for a mesh: leave it out, or give a "
                             "cloud; a mesh is turned by {MeshSettings::flip}")};
}

/** Takes a cloud or a surface, see SurfaceInput, or a mesh. The last one set counts. Base of DrivePath, CutterLocation,
 *  DeviationEstimation and MaterialRemoval. */
template <typename PointT>
class MeshInput : public SurfaceInput<pcl::PCLBase<PointT>, PointT> {
public:
  /** The scan. Clears a surface, a mesh, and what is reused of them. */
  void setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputCloud(cloud);
    forgetInputs(false);
  }
  /** \see SurfaceInput::setInputSurface */
  void setInputSurface(const Surface::ConstPtr& surface) override
  {
    SurfaceInput<pcl::PCLBase<PointT>, PointT>::setInputSurface(surface);
    forgetInputs(false);
  }
  /** A mesh, prepared by compute. */
  void setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh)
  {
    this->given_surface_.reset();
    forgetInputs(true);
    polygons_ = mesh;
  }
  /** The same with a mesh made with your own settings. */
  void setInputMesh(const SurfaceMesh::ConstPtr& mesh)
  {
    this->given_surface_.reset();
    forgetInputs(true);
    mesh_ = mesh;
  }

protected:
  /** Called for each new input, after on_mesh_ is set: clears what was made of the one before. */
  virtual void forgetMade() {}

  /** Prepares the mesh, if it was given as polygons. InvalidInput without one. */
  Status prepareMesh(const MeshSettings& settings)
  {
    if (polygons_)
      if (const Status status = SurfaceMesh::make(*polygons_, settings, mesh_); !status.ok())
        return status;
    if (!mesh_)
      return {StatusCode::InvalidInput, "the input mesh is missing: call {setInputMesh} with a mesh that has faces"};
    return Status::success();
  }

  /** Ok, or an error if \p surface has guessed points in its gaps. \p objection: why they cannot be used. */
  static Status checkMeasured(const Surface& surface, const std::string& objection)
  {
    if (surface.report().guessed == 0)
      return Status::success();
    return {StatusCode::InvalidInput, Diagnostic("the surface has ", surface.report().guessed, " points that were put into gaps, ",
                                                 objection, ": give the surface as it was before {GapBridging}")};
  }

  bool on_mesh_ = false;       ///< the mesh is the last input set
  SurfaceMesh::ConstPtr mesh_; ///< of setInputMesh, or made of the polygons

private:
  void forgetInputs(bool on_mesh)
  {
    on_mesh_ = on_mesh;
    polygons_.reset();
    mesh_.reset();
    forgetMade();
  }

  pcl::PolygonMesh::ConstPtr polygons_;
};

} // namespace pcl_spiral
