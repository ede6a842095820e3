// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points spread evenly over the curved surface of a mesh.
 */
#pragma once

#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <pcl/PolygonMesh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points with normals on the curved surface of a mesh (SurfaceMesh::patch), for all stages that work on a cloud.
 *
 *  Every place of the surface lies within one spacing of a point, in a straight line. Points are at least
 *  0.68 spacings apart, except on the rim, which has points of its own: at its corners, and between these
 *  no farther than 0.8 spacings apart. The size of the faces has no effect. The points are the same for
 *  any number of threads, and for any order of the faces and of their corners (if fitted normals differ in
 *  the last bit, single points may differ). Another position of the part gives other points, equally even.
 *
 *  Method: candidates lie on a lattice of each face, a quarter of a spacing wide. They are taken in the order of a hash of
 *  their place, unless one taken earlier is too near (dart throwing; Cook, Stochastic sampling in computer graphics, ACM
 *  TOG 5(1), 1986). Cells that are far enough apart are filled at the same time. Lengths in mm. Memory: 350 bytes per point.
 *  \code
 *  pcl_spiral::MeshSampling sampling;
 *  sampling.setInputMesh(mesh);
 *  pcl::PointCloud<pcl::PointNormal> samples;
 *  sampling.compute(samples); // empty on failure: sampling.getStatus() says why
 *  \endcode
 */
class MeshSampling : public ThreadCount {
public:
  using Ptr = std::shared_ptr<MeshSampling>;            ///< A shared pointer.
  using ConstPtr = std::shared_ptr<const MeshSampling>; ///< A shared pointer to a constant one.

  /** The mesh, or one prepared earlier. The last input set counts. */
  void setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh);
  void setInputMesh(const SurfaceMesh::ConstPtr& mesh);              ///< The same with a prepared mesh.
  pcl::PolygonMesh::ConstPtr getInputMesh() const { return input_; } ///< The value of setInputMesh.
  /** The prepared mesh, as given or after compute. */
  SurfaceMesh::ConstPtr getSurfaceMesh() const { return mesh_; }

  /** How a PolygonMesh is prepared. */
  void setMeshSettings(const MeshSettings& settings) { settings_ = settings; }
  const MeshSettings& getMeshSettings() const { return settings_; } ///< The value of setMeshSettings.

  /** Distance between points, mm; 0, the default: defaultSampleSpacing. */
  void setSpacing(double spacing) { spacing_ = spacing; }
  double getSpacing() const { return spacing_; } ///< The value of setSpacing.
  /** The spacing used by the last compute, mm. */
  double getUsedSpacing() const { return used_spacing_; }

  /** Samples only the faces for which \p chosen is not 0, one value per face
   *  of the SurfaceMesh; their boundary is the rim. Empty, the default: all. */
  void setFaces(std::vector<std::uint8_t> chosen) { chosen_ = std::move(chosen); }
  const std::vector<std::uint8_t>& getFaces() const { return chosen_; } ///< The value of setFaces.

  /** Points nearer than this to a crease between sampled faces are marked, mm, see getInCreaseBand; 0, the default: none. */
  void setCreaseBand(double width) { crease_band_ = width; }
  double getCreaseBand() const { return crease_band_; } ///< The value of setCreaseBand.

  /** Computes the points. \p output is empty on failure: no or unfit mesh, a setting out of range, no face chosen, too little memory. */
  void compute(pcl::PointCloud<pcl::PointNormal>& output);

  /** Of each point: the face of the SurfaceMesh on which it lies. */
  const std::vector<std::uint32_t>& getFaceIndices() const { return faces_; }
  /** Of each point: 1 in the crease band. */
  const std::vector<std::uint8_t>& getInCreaseBand() const { return in_band_; }
  const Status& getStatus() const { return status_; } ///< Result of the last compute.

private:
  Status run(pcl::PointCloud<pcl::PointNormal>& output);

  pcl::PolygonMesh::ConstPtr input_;
  SurfaceMesh::ConstPtr mesh_;
  MeshSettings settings_;
  double spacing_ = 0.0, used_spacing_ = 0.0, crease_band_ = 0.0;
  std::vector<std::uint8_t> chosen_, in_band_;
  std::vector<std::uint32_t> faces_;
  Status status_;
};

/** A spacing, mm, at which local fits reproduce the curved surface of the chosen faces. It is 0.1 r^(3/4), where r is the radius
 *  of curvature that all but a thousandth of the area exceeds, from the bows of the edges. A quadric fitted over about four such
 *  spacings is off by about 1e-4 mm on a sphere. The spacing is limited to give at least 100,000 and at most 500,000 points. */
double defaultSampleSpacing(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen = {});

} // namespace pcl_spiral
