// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The solid that a cutter sweeps along the linear moves of its path.
 */
#pragma once

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/fit/impl/mls_surface.h>
#include <pcl_spiral/search/impl/move_index.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** Height of something above a surface, mm, negative in the material, and the nearest place of the surface. */
struct SurfaceHeight {
  double height = 0.0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
};

/** The stock over a place: where a ray from it first meets what a cutter sweeps. */
struct Stock {
  double height = 0.0;  ///< mm; negative: gouge
  std::size_t move = 0; ///< that cuts there
  bool met = false;
};

/** A cutter of revolution at every point of a path, moved in straight
 *  lines from one point to the next, except at lifts.
 *
 *  Search and figures use only these functions of a cutter: BallSweep, and ProfileSweep for any
 *  other. Holders belong to collision checks. Lengths in mm. */
class CutterSweep {
public:
  virtual ~CutterSweep() = default;
  CutterSweep(const CutterSweep&) = delete; // the search refers to the path
  CutterSweep& operator=(const CutterSweep&) = delete;

  /** The centre of a ball that contains the cutter, at every point of the path; move i goes from i to i + 1. */
  const Polyline& centres() const { return centres_; }
  std::size_t moves() const { return centres_.size() < 2 ? 0 : centres_.size() - 1; }
  /** Whether the cutter is lifted on \p move, and sweeps nothing. */
  bool isLift(std::size_t move) const { return beginsPass(passes_, move + 1); }
  /** Radius of that ball. */
  double boundingRadius() const { return bounding_radius_; }

  /** Lowers \p t to the smallest t in [-start, t) at which x + t n lies in the solid swept
   *  along \p move. Returns false, and keeps \p t, if there is none. \p n is unit. */
  virtual bool enter(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const = 0;
  /** Whether \p x lies in the solid swept along \p move. */
  virtual bool contains(std::size_t move, const Eigen::Vector3d& x) const = 0;
  /** The shortest way out of the cutter from \p x, where it is deepest in it on \p move; negative outside, -infinity on a lift. */
  virtual double depth(std::size_t move, const Eigen::Vector3d& x) const = 0;
  /** The same as enter for all moves: lowers the height of \p stock, and sets the move. */
  virtual void enterAny(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, Stock& stock) const = 0;
  /** The largest depth of \p x over all moves; 0 if it is in none. */
  virtual double deepest(const Eigen::Vector3d& x) const = 0;
  /** Height of the cutter above the surface about \p foot, a quadric no wider than \p reach,
   *  at the share \p f of \p move. Negative: how deep it cuts below the surface. */
  virtual SurfaceHeight lowest(std::size_t move, double f, const SurfaceFoot& foot, double reach) const = 0;

protected:
  CutterSweep(Polyline centres, double bounding_radius, std::vector<std::size_t> passes)
  : centres_(std::move(centres)), bounding_radius_(bounding_radius), passes_(std::move(passes))
  {}
  const std::vector<std::size_t>& passes() const { return passes_; }
  /** Enters one move. */
  void take(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, Stock& stock) const
  {
    if (!enter(move, x, n, start, stock.height))
      return;
    stock.move = move;
    stock.met = true;
  }

private:
  Polyline centres_;
  double bounding_radius_;
  std::vector<std::size_t> passes_;
};

/** A ball: each move sweeps a capsule, so all answers are exact; the tool axis has no effect. */
class BallSweep : public CutterSweep {
public:
  /** The centres are one radius off the contacts, along the normals. One unit
   *  normal per contact. \p passes: points to which the cutter is lifted. */
  BallSweep(const Polyline& contacts, const std::vector<Eigen::Vector3d>& normals, double radius,
            const std::vector<std::size_t>& passes = {});

  bool enter(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const override;
  bool contains(std::size_t move, const Eigen::Vector3d& x) const override;
  double depth(std::size_t move, const Eigen::Vector3d& x) const override;
  void enterAny(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, Stock& stock) const override;
  double deepest(const Eigen::Vector3d& x) const override;
  SurfaceHeight lowest(std::size_t move, double f, const SurfaceFoot& foot, double reach) const override;

private:
  MoveIndex index_;
};

/** Height of \p p above the quadric about \p foot: signed distance, positive out of the material. If the nearest place is farther
 *  than \p reach from the foot, across the normal, the distance is from the place on the way there that is within \p reach. */
SurfaceHeight heightAbove(const SurfaceFoot& foot, const Eigen::Vector3d& p, double reach);

} // namespace pcl_spiral
