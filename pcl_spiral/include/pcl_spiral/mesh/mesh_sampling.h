/** \file
 *  Points spread evenly over the curved surface of a mesh.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/mesh/surface_mesh.h>

#include <pcl/PolygonMesh.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points with normals of a mesh's curved surface (SurfaceMesh::patch), for every stage that works on a cloud.
 *
 *  Every place of the surface lies within one spacing of a point, measured straight; points stand 0.68 spacings or more apart,
 *  but on the rim, which has points of its own, at its corners and no farther than 0.8 spacings apart between these. How large
 *  the faces are does not matter. The points are the same for any number of threads, and whatever the order of the faces and of
 *  their corners (where fitted normals differ in the last bit, single points may). Another position of the part gives other
 *  points, as even.
 *
 *  Method: candidates on a lattice of each face, a quarter of a spacing wide, are taken in the order of a hash of their place,
 *  unless one taken before lies too near (dart throwing; Cook, Stochastic sampling in computer graphics, ACM TOG 5(1), 1986), in
 *  cells of which those far enough apart are filled at the same time. Lengths in mm. Memory: 350 bytes a point.
 *  \code
 *  pcl_spiral::MeshSampling sampling;
 *  sampling.setInputMesh(mesh);
 *  pcl::PointCloud<pcl::PointNormal> samples;
 *  sampling.compute(samples); // empty on failure: sampling.getStatus() says why
 *  \endcode
 */
class MeshSampling : public ThreadCount {
public:
  using Ptr = std::shared_ptr<MeshSampling>;
  using ConstPtr = std::shared_ptr<const MeshSampling>;

  /** The mesh, or one made ready before. What is set last counts. */
  void setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh);
  void setInputMesh(const SurfaceMesh::ConstPtr& mesh);
  pcl::PolygonMesh::ConstPtr getInputMesh() const { return input_; }
  /** The mesh made ready, as given or after compute. */
  SurfaceMesh::ConstPtr getSurfaceMesh() const { return mesh_; }

  /** How a PolygonMesh is made ready. */
  void setMeshSettings(const MeshSettings& settings) { settings_ = settings; }
  const MeshSettings& getMeshSettings() const { return settings_; }

  /** 0, the default: defaultSampleSpacing. */
  void setSpacing(double spacing) { spacing_ = spacing; }
  double getSpacing() const { return spacing_; }
  /** As used by the last compute. */
  double getUsedSpacing() const { return used_spacing_; }

  /** Sample the faces alone for which \p chosen is not 0, one value a face of the SurfaceMesh; their boundary is the rim.
   *  Empty, the default: all. */
  void setFaces(std::vector<std::uint8_t> chosen) { chosen_ = std::move(chosen); }
  const std::vector<std::uint8_t>& getFaces() const { return chosen_; }

  /** Points nearer than this to a crease between sampled faces are marked, see getInCreaseBand; 0, the default: none. */
  void setCreaseBand(double width) { crease_band_ = width; }
  double getCreaseBand() const { return crease_band_; }

  /** \p output is empty on failure: no or unfit mesh, a setting out of range, no face chosen, more points than memory holds. */
  void compute(pcl::PointCloud<pcl::PointNormal>& output);

  /** Of each point: the face of the SurfaceMesh it lies on. */
  const std::vector<std::uint32_t>& getFaceIndices() const { return faces_; }
  /** Of each point: 1 in the crease band. */
  const std::vector<std::uint8_t>& getInCreaseBand() const { return in_band_; }
  const Status& getStatus() const { return status_; }

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

/** A spacing, mm, at which local fits find the curved surface of the faces chosen again: the radius of curvature r that all but
 *  a thousandth of the area exceeds, by the bows of the edges, asks for 0.1 r^(3/4), at which a quadric fitted over some
 *  four spacings is off by about 1e-4 mm on a sphere; no wider than gives 100,000 points, no closer than gives 500,000. */
double
defaultSampleSpacing(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen = {});

} // namespace pcl_spiral
