// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The part of a mesh by which a path is judged, as points.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/mesh/impl/crease_lines.h>
#include <pcl_spiral/mesh/impl/mesh_rims.h>
#include <pcl_spiral/mesh/surface_mesh.h>
#include <pcl_spiral/verify/impl/cutter_path.h>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** Samples of the curved surface of a mesh, with its rims and creases.
 *
 *  Of an open mesh all faces are judged. Of a closed mesh, such as a solid: the faces of the smooth
 *  areas, bounded by creases, that have a contact of the path. Faces that look away from the cutter
 *  are left out: more than 0.1 (the cosine) below the mean tool axis and the normals of all contacts. */
class ReferenceMesh {
public:
  using ConstPtr = std::shared_ptr<const ReferenceMesh>;

  /** \p spacing of the samples; 0: defaultSampleSpacing. \p result is null on failure:
   *  more samples than memory holds, or a closed mesh that the path does not touch. */
  static Status make(const SurfaceMesh::ConstPtr& mesh, const CutterPath& path, double spacing, ConstPtr& result);

  const SurfaceMesh& mesh() const { return *mesh_; }
  /** Not 0 for each face that is judged; empty: all are. */
  const std::vector<std::uint8_t>& faces() const { return faces_; }
  std::size_t faceCount() const;
  /** Area of the judged faces, mm^2. */
  double area() const;
  const pcl::PointCloud<pcl::PointNormal>::ConstPtr& samples() const { return samples_; }
  double spacing() const { return spacing_; }
  /** Of each sample: the face on which it lies. */
  const std::vector<std::uint32_t>& sampleFaces() const { return sample_faces_; }
  /** Place of sample \p i on its face as it is, flat. */
  Eigen::Vector3d flatPlace(std::size_t i) const;
  const std::vector<MeshRim>& rims() const { return rims_; }
  const CreaseLines& creases() const { return *creases_; }
  /** What was left out of the mesh, and what was found in it, in words. */
  const Diagnostics& warnings() const { return warnings_; }

private:
  Status chooseFaces(const CutterPath& path);

  SurfaceMesh::ConstPtr mesh_;
  std::vector<std::uint8_t> faces_;
  pcl::PointCloud<pcl::PointNormal>::ConstPtr samples_;
  double spacing_ = 0.0;
  std::vector<std::uint32_t> sample_faces_;
  std::vector<MeshRim> rims_;
  std::unique_ptr<CreaseLines> creases_;
  Diagnostics warnings_;
};

/** The most, mm, by which the surface behind face \p t may lie off it, as the bends of the mesh about its corners tell. Of an arc
 *  with chords w the curvature is theta / w, where theta is the angle between the faces at an edge and w the height of the smaller one
 *  over it; the sagitta of the face is its width across the edge squared, times the curvature, over 8. Twice the largest of these, as
 *  the surface may bend as much in the other direction. A face more than four times as wide does not bend with the faces beside it,
 *  and edges that are creases are not looked at. Zero for a face that is flat, SurfaceMesh::isFlat(). */
double bendDepth(const SurfaceMesh& mesh, std::size_t t);

} // namespace pcl_spiral
