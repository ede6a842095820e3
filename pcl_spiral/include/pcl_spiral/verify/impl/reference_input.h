// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the classes that judge a path have in common: the scan or mesh by which it is judged.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/mesh/impl/mesh_input.h>
#include <pcl_spiral/verify/impl/cutter_path.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <memory>

namespace pcl_spiral {

/** Takes a reference (a cloud or a surface, see SurfaceInput, or a mesh) and a toolpath. Base of DeviationEstimation and MaterialRemoval.
 *
 *  You may give the planner's own surface (setInputSurface); then none has to be made. Its points are cleaned
 *  and oriented as for the planner, but the fit that judges is a different one, see ReferenceSurface. */
template <typename PointT>
class ReferenceInput : public MeshInput<PointT> {
public:
  using ToolpathConstPtr = pcl::PointCloud<ToolpathPoint>::ConstPtr; ///< A toolpath, shared.

  ReferenceInput() { this->surfaceSettings().strict = false; } // a rough reference is accepted, with a warning

  /** Judges by samples of the curved surface of this mesh; see ReferenceMesh and ReferenceSurface. Its faces give the
   *  side: a view point or another setting for scans is refused. The last input set counts: cloud, surface or mesh. */
  using MeshInput<PointT>::setInputMesh;
  /** The prepared mesh, as given or after compute; null without one. */
  SurfaceMesh::ConstPtr getSurfaceMesh() const { return this->mesh_; }

  /** How a PolygonMesh is prepared: creases, normals, side. */
  void setMeshSettings(const MeshSettings& settings) { mesh_settings_ = settings; }
  const MeshSettings& getMeshSettings() const { return mesh_settings_; } ///< The value of setMeshSettings.

  /** Distance between the samples of a mesh, mm; 0, the default: defaultSampleSpacing. */
  void setSampleSpacing(double spacing) { sample_spacing_ = spacing; }
  double getSampleSpacing() const { return sample_spacing_; } ///< The value of setSampleSpacing.

  /** The path to judge. Its points have contact and normal; the axis is used if there is one. \p passes:
   *  where the second pass and each further one begin; the tool is lifted to these points and does not
   *  cut on the way. Empty, the default: where the arc length does not grow, see passBegins. */
  void setInputToolpath(const ToolpathConstPtr& toolpath, std::vector<std::size_t> passes = {})
  {
    toolpath_ = toolpath;
    passes_ = std::move(passes);
  }
  ToolpathConstPtr getInputToolpath() const { return toolpath_; }       ///< The value of setInputToolpath.
  const std::vector<std::size_t>& getPasses() const { return passes_; } ///< The passes of setInputToolpath.

  /** Chord error asked of the path, mm, compared with the noise; 0.005 by default. */
  void setChordError(double error) { chord_error_ = error; }
  double getChordError() const { return chord_error_; } ///< The value of setChordError.

  /** Called with the completed share; return false to cancel. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** Judges by a fit made earlier of the same cloud or surface, so that it is not made twice. \see
   *  getReferenceSurface. A null pointer, the default: made at every compute. setInputCloud, setInputSurface
   *  and setInputMesh clear it. For a closed mesh, it is the fit of the faces that its path touched. */
  void setReferenceSurface(const std::shared_ptr<const ReferenceSurface>& surface) { given_reference_ = surface; }
  /** The fit of the last compute; null before. */
  std::shared_ptr<const ReferenceSurface> getReferenceSurface() const { return reference_; }

protected:
  /** Reads the path and makes the surface. */
  Status prepare(CutterPath& path);
  Status prepareMeshReference(const CutterPath& path); ///< Makes the reference of the mesh, near the contacts of \p path.
  /** A mesh takes the place of a cloud, whose points would be judged. */
  void forgetMade() override
  {
    given_reference_.reset();
    if (this->on_mesh_)
      this->input_.reset();
  }

  ToolpathConstPtr toolpath_;                               ///< of setInputToolpath
  std::vector<std::size_t> passes_;                         ///< of setInputToolpath
  MeshSettings mesh_settings_;                              ///< of setMeshSettings
  double sample_spacing_ = 0.0;                             ///< of setSampleSpacing
  double chord_error_ = 0.005;                              ///< of setChordError
  ProgressCallback progress_;                               ///< of setProgressCallback
  std::shared_ptr<const ReferenceSurface> given_reference_; ///< of setReferenceSurface
  std::shared_ptr<const ReferenceSurface> reference_;       ///< of the last compute
};

} // namespace pcl_spiral

#include <pcl_spiral/verify/impl/reference_input.hpp>
