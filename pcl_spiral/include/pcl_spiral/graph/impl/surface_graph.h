// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Results of one pass over the neighbourhoods of a cloud: order, normals, spacing, triangles.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/height_grid.h>
#include <pcl_spiral/graph/impl/triangulation.h>
#include <pcl_spiral/graph/outer_side.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <memory>
#include <optional>

namespace pcl_spiral {

/** Options of a SurfaceGraph. */
struct SurfaceGraphOptions {
  int neighbours = 32;                       ///< in one neighbourhood; doubled while stars stay open (scan lines)
  double max_circumradius = 3.0;             ///< of a triangle, in local spacings: larger empty circles are outside or holes
  std::optional<Eigen::Vector3d> view_point; ///< normals face it; absent: towards +z as a whole
  bool flip_normals = false;
  std::vector<Eigen::Vector3f> given_normals; ///< one per point (zero: none), or empty; they face the outer side
  bool trust_normals = true;                  ///< false: given normals without a common side decide nothing
  /** The points are nodes of this grid, which define triangles and side, see BallClosing. Absent: they are found from the points. */
  std::optional<HeightGrid> heights;
};

/** A cloud in spatial order with oriented PCA normals, local spacing and a triangulation of local Delaunay stars.
 *
 *  Every stage of a spiral works on one such graph, made once and shared: a copy refers to the same data, which never change. Points are
 *  finite and all different. Normals point out of the material, to the side of the cutter.
 */
class SurfaceGraph {
public:
  static constexpr std::size_t fewest_points = 50;

  SurfaceGraph() = default;
  SurfaceGraph(const SurfaceGraph&) = default; // and no move: what is left would have no data
  SurfaceGraph& operator=(const SurfaceGraph&) = default;

  /** Make the graph. \p points must be finite. Fails on fewer than 50, or if they do not form a surface. */
  Status build(std::vector<Eigen::Vector3f> points, const SurfaceGraphOptions& options);
  /** The same for points already in spatial order. */
  Status build(PointBlocks blocks, const SurfaceGraphOptions& options);

  std::size_t size() const { return points_->blocks.size(); }
  const PointBlocks& blocks() const { return points_->blocks; }
  Eigen::Vector3d position(std::size_t i) const { return points_->blocks.position(i); }
  Eigen::Vector3d normal(std::size_t i) const { return points_->normals[i].cast<double>(); }
  const std::vector<Eigen::Vector3f>& normals() const { return points_->normals; }
  /** Distance to the k-th neighbour. */
  float radius(std::size_t i) const { return points_->radii[i]; }
  int neighbours() const { return points_->neighbours; }
  /** Median distance between neighbouring points, mm, as if they were spread evenly. */
  double spacing() const { return points_->spacing; }
  /** The same about point \p i. */
  double spacing(std::size_t i) const;
  /** Isolated points off the surface, as indices of the points given to build: outliers to leave out. Ascending. */
  const std::vector<std::uint32_t>& isolatedPoints() const { return points_->isolated; }
  /** Points, in the graph's order, that may be spikes or lie where the surface bends. spikeOutliers() checks them. */
  const std::vector<std::uint32_t>& spikeCandidates() const { return points_->spike_candidates; }
  const Triangulation& triangulation() const { return *triangulation_; }
  /** The same points without the triangles, which are the larger half of the memory: for stages that need only neighbourhoods. */
  SurfaceGraph withoutTriangulation() const;
  /** Mean of the normals by area: the side that the part shows as a whole; zero on a closed surface. */
  Eigen::Vector3d meanNormal() const { return points_->mean_normal; }
  /** How the outer side was found. */
  const OuterSide& side() const { return points_->side; }

private:
  struct Points {
    PointBlocks blocks;
    std::vector<Eigen::Vector3f> normals;
    std::vector<float> radii;
    std::vector<std::uint32_t> isolated, spike_candidates;
    Eigen::Vector3d mean_normal = Eigen::Vector3d::Zero();
    double spacing = 0.0;
    int neighbours = 0;
    OuterSide side;
  };

  std::shared_ptr<const Points> points_ = std::make_shared<const Points>();
  std::shared_ptr<const Triangulation> triangulation_ = std::make_shared<const Triangulation>();
};

/** Area of the surface, mm2: the sum of each point's share. */
double surfaceArea(const SurfaceGraph& graph);

} // namespace pcl_spiral
