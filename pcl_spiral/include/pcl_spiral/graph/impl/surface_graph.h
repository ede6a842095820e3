/** \file
 *  What one pass over a cloud's neighbourhoods finds: order, normals, spacing, triangles.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/search/impl/point_blocks.h>
#include <pcl_spiral/graph/impl/triangulation.h>

#include <optional>

namespace pcl_spiral {

/** How a SurfaceGraph is made. */
struct SurfaceGraphOptions {
  int neighbours = 32;           ///< in one neighbourhood; doubled as long as stars stay open (scan lines)
  double max_circumradius = 3.0; ///< of a triangle, in local spacings: larger empty circles are outside or holes
  std::optional<Eigen::Vector3d> view_point; ///< normals face it; absent: towards +z as a whole
  bool flip_normals = false;
  std::vector<Eigen::Vector3f> given_normals; ///< one a point (zero: none), or empty: the side they face is the outer
};

/** A cloud in spatial order with oriented PCA normals, local spacing and a triangulation of local Delaunay stars.
 *
 *  Every stage of a spiral works on one of these, made once and shared. Points are finite and all different.
 *  Normals point out of the material, to the side the cutter is on.
 */
class SurfaceGraph {
public:
  static constexpr std::size_t fewest_points = 50;

  SurfaceGraph() = default;

  /** Make the graph. \p points must be finite; fails on fewer than 50, or when they do not form a surface. */
  Status build(std::vector<Eigen::Vector3f> points, const SurfaceGraphOptions& options);
  /** The same of points already in spatial order. */
  Status build(PointBlocks blocks, const SurfaceGraphOptions& options);

  std::size_t size() const { return blocks_.size(); }
  const PointBlocks& blocks() const { return blocks_; }
  Eigen::Vector3d position(std::size_t i) const { return blocks_.position(i); }
  Eigen::Vector3d normal(std::size_t i) const { return normals_[i].cast<double>(); }
  const std::vector<Eigen::Vector3f>& normals() const { return normals_; }
  /** Distance to the k-th neighbour. */
  float radius(std::size_t i) const { return radii_[i]; }
  int neighbours() const { return neighbours_; }
  /** Median distance between neighbouring points, mm, as if they were spread evenly. */
  double spacing() const { return spacing_; }
  /** The same about point \p i. */
  double spacing(std::size_t i) const;
  /** Points, as indices of what build was given, that stand alone off the surface: outliers to leave out. Ascending. */
  const std::vector<std::uint32_t>& strayPoints() const { return stray_points_; }
  /** Points, in the graph's order, that may be false or lie where the surface bends: what falsePoints() looks at. */
  const std::vector<std::uint32_t>& doubtfulPoints() const { return doubtful_points_; }
  const Triangulation& triangulation() const { return triangulation_; }
  /** Forget the triangles, the larger half of the graph's memory, when only neighbourhoods are asked for from now on. */
  void dropTriangulation() { triangulation_ = Triangulation(); }
  /** Mean of the normals by area: the side the part shows as a whole; zero on a closed surface. */
  Eigen::Vector3d meanNormal() const { return mean_normal_; }
  /** Whether +z told the outer side clearly; if not, the convex side was taken. */
  bool orientationIsClear() const { return orientation_is_clear_; }

private:
  PointBlocks blocks_;
  std::vector<Eigen::Vector3f> normals_;
  std::vector<float> radii_;
  std::vector<std::uint32_t> stray_points_, doubtful_points_;
  Triangulation triangulation_;
  Eigen::Vector3d mean_normal_ = Eigen::Vector3d::Zero();
  double spacing_ = 0.0;
  int neighbours_ = 0;
  bool orientation_is_clear_ = true;
};

} // namespace pcl_spiral
