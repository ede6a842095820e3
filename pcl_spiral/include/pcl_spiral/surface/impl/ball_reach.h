// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a ball reaches a surface, and where it must stop before it.
 */
#pragma once

#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/surface/impl/missed_points.h>
#include <pcl_spiral/surface/impl/surface_beyond.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace pcl_spiral {

/** A point of a surface that a ball does not reach. Lengths in mm. */
struct UnreachedPoint {
  std::uint32_t index = 0; ///< in the order of the graph
  float reach = 0.0f;      ///< radius of the largest ball that reaches it
  float area = 0.0f;       ///< of the surface about it, mm^2
  bool covered = false;    ///< an obstacle is in the way of the ball
};

/** Points over a surface that a ball must not touch, nor pass under. Lengths in mm. */
struct BallObstacles {
  std::vector<Eigen::Vector3f> points; ///< each stands on a post from the surface
  double clearance = 0.0;              ///< between them and the ball
};

/** A ball on the outer side of a fitted surface: how large it may be to reach a place, and where it rests if it is too large.
 *
 *  The surface is the fit at the points of the graph, with a patch of second order at each point. A ball is free if no patch is deeper
 *  in it than tolerance(). The largest ball at a foot is found by shrinking (Ma, Bae and Choi 2012, 3D medial axis point approximation
 *  using nearest neighbors and the normal field). A ball that is too large rests at the free place nearest to the largest one. Over
 *  obstacles the ball is lifted along the normal of its foot, as when a cutter is dropped onto points (drop cutter). Where the surface
 *  continues beyond the graph, its patches hold the ball as those of the graph do.
 *
 *  Where it is clear from the points alone that the ball reaches all of them, patches are fitted only when one is asked for: ask
 *  once before a parallel loop does, and before dropSurface. Every point is looked at once: near-linear, in parallel, the same for any
 *  number of threads. Memory: about 70 bytes per point, and per patch in a void between points, where the ball does not reach all of
 *  them. */
class BallReach {
public:
  /** Shares the points of \p graph and \p fit. \p tolerance, mm: depth that counts as noise of the surface. \p beyond: the surface
   *  beside that of the graph, see surfaceBeyond. \p least_reached: where the ball surely reaches a smaller share of the points than
   *  this, not all of them are looked at, see looked(). To look at all takes the square of their number where almost all are equally
   *  near to the centre of the ball, as on a bowl with its radius. */
  BallReach(const SurfaceGraph& graph, const MlsSurface& fit, double radius, double tolerance, const BallObstacles& obstacles = {},
            const std::vector<SurfacePatch>& beyond = {}, double least_reached = 0.0);

  /** Gives up the points of the surface: from now on no patch is fitted any more. */
  void dropSurface();

  double radius() const { return radius_; }       ///< Of the ball, mm.
  double tolerance() const { return tolerance_; } ///< As given, mm.

  std::size_t size() const { return size_; } ///< Points of the graph.
  /** Points that were looked at: all, or, where the share reached is too small, one at random of every few. */
  std::size_t looked() const { return looked_; }
  /** Points that the ball does not reach, in the order of the graph. */
  const std::vector<UnreachedPoint>& unreached() const { return unreached_; }
  /** Points that the fit cuts off. */
  const MissedPoints& missed() const { return missed_; }
  /** Adds to missed() those of \p outliers, left out of the fit, that stand at most \p most, mm, out of it: higher ones are no edge. */
  void addMissed(const MlsSurface& fit, const std::vector<Eigen::Vector3f>& outliers, double most);
  /** Foot and normal of point \p i of the graph. */
  Eigen::Vector3d position(std::size_t i) const { return patches().feet.position(patches().place[i]); }
  Eigen::Vector3d normal(std::size_t i) const { return patches().patches[patches().place[i]].normal.cast<double>(); }
  /** True if a point that the ball does not reach lies within \p distance of \p place. */
  bool isNearUnreached(const Eigen::Vector3d& place, double distance) const;
  /** True if an obstacle, or its post, lies within \p distance of \p place. */
  bool isNearObstacle(const Eigen::Vector3d& place, double distance) const;
  /** The same of the surface beyond the graph. */
  bool isNearBeyond(const Eigen::Vector3d& place, double distance) const;
  /** True if the surface beyond the graph is known. */
  bool hasBeyond() const { return beyond_.size() > 0; }

  /** Radius of the largest free ball that touches the surface at \p foot, where its outer normal is \p normal; at most radius(). Without
   *  regard to obstacles. */
  double reach(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal) const;
  /** Centre of the ball for the contact \p foot: foot + radius() normal where that is free, above that where only an obstacle is in
   *  the way, else the free place nearest to the largest ball that touches there. Not finite if there is none: the surface closes round
   *  the place. */
  Eigen::Vector3d centre(const Eigen::Vector3d& foot, const Eigen::Vector3d& normal) const;
  /** The first free centre from \p centre along the unit vector \p up if an obstacle, or the surface beyond the graph, is in the ball
   *  there; else \p centre. */
  Eigen::Vector3d overObstacles(const Eigen::Vector3d& centre, const Eigen::Vector3d& up) const;
  /** The first free centre from \p from along the unit vector \p direction. */
  Eigen::Vector3d freeAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const;
  /** How much deeper than tolerance() the surface is in the ball at \p centre, mm; 0 if that is free. */
  double excess(const Eigen::Vector3d& centre) const;
  /** Distance of the ball at \p centre from the surface in which it may be as deep as tolerance(), mm; at most \p most, and negative by
   *  excess(). */
  double height(const Eigen::Vector3d& centre, double most) const;
  /** Height of the material that the ball leaves above each unreached point, mm. */
  std::vector<float> heightsLeft() const;

private:
  /** A quadric about a point: along direction1 and across it. */
  struct Patch {
    Eigen::Vector3f normal = Eigen::Vector3f::UnitZ(), direction1 = Eigen::Vector3f::UnitX();
    float curvature1 = 0.0f, curvature2 = 0.0f;
    float extent = 0.0f; ///< mm
  };

  /** The patches, in the order of their feet. */
  struct Patches {
    PointBlocks feet;
    std::vector<Patch> patches;
    std::vector<std::uint32_t> place; ///< in feet, of each point of the graph
    float widest = 0.0f;              ///< extent of a patch, mm

    /** Takes the patches at \p places; \p fitted are in the order that these were made from, the first \p points those of the graph. */
    void keep(PointBlocks places, const std::vector<Patch>& fitted, std::size_t points);
  };

  /** The triangles are of no use any more. */
  void dropTriangulation();
  const Patches& patches() const;
  Patches fitPatches(const std::vector<SurfacePatch>& beyond, std::vector<float>& heights) const;
  static Patch patchOf(const SurfaceFoot& foot, double extent);
  void findUnreached(double least_reached);
  /** Looks at one point of \p every, at random, and keeps those that the ball does not reach. */
  void lookAt(std::size_t every, const std::vector<std::uint8_t>& empty);
  /** For each foot, whether the ball there is so far from all feet, by the widths of their patches, that none is in it. */
  std::vector<std::uint8_t> emptyBalls() const;
  void averageNormals();
  /** Adds patches in the voids about unreached points in which a ball would sink by more than the tolerance between the patches. */
  void coverVoids();
  static Eigen::Vector3d nearestOn(const Patch& patch, const Eigen::Vector3d& foot, const Eigen::Vector3d& from);
  /** The point of the surface nearest to \p from, if it is nearer than \p within. Near \p own, the steps between neighbouring patches
   *  would count as hollows: there only points nearer than \p own_within count. */
  bool nearestOnSurface(const Eigen::Vector3d& from, double within, Eigen::Vector3d& point, const Eigen::Vector3d* own = nullptr,
                        double own_within = 0.0) const;
  /** The same of the spheres of the clearance about the obstacles. */
  bool nearestObstacle(const Eigen::Vector3d& from, double within, Eigen::Vector3d& point) const;
  /** The nearer of both. */
  bool nearest(const Eigen::Vector3d& from, double within, Eigen::Vector3d& point) const;
  void setObstacles(const BallObstacles& obstacles);
  bool isCovered(std::size_t i) const;
  /** Mean normal of the surface \p within a distance of \p from; of the whole surface if that is not clear. */
  Eigen::Vector3d wayOut(const Eigen::Vector3d& from, double within) const;
  bool isFreeAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, Eigen::Vector3d& free) const;
  Eigen::Vector3d slid(Eigen::Vector3d centre, const Eigen::Vector3d& target) const;
  bool isOutside(const Eigen::Vector3d& centre) const;

  SurfaceGraph graph_; ///< without triangles once it is made
  std::optional<MlsSurface> fit_;
  std::size_t size_, looked_;
  double radius_, tolerance_;
  double own_, own_tolerance_; // mm: radius about a foot, and the depth that counts as noise there
  MissedPoints missed_;
  mutable Patches patches_; // by patches() alone
  mutable std::once_flag are_fitted_;
  std::vector<Eigen::Vector3f> block_normals_; // mean of each block of the feet
  std::vector<UnreachedPoint> unreached_;
  PointBlocks unreached_feet_;
  PointBlocks obstacles_;  // with points of their posts
  PointBlocks beyond_;     // feet of the surface beyond the graph
  double clearance_ = 0.0; // mm
  Eigen::Vector3d side_;
};

/** The tolerance for a surface: three standard deviations of the fit, below which a scan shows nothing, at least \p least, mm. */
double reachTolerance(const MlsSurface& fit, double least);

} // namespace pcl_spiral
