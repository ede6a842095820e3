// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The solid that any cutter of revolution sweeps along the linear moves of its path.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/verify/impl/cutter_path.h>
#include <pcl_spiral/verify/impl/cutter_sweep.h>
#include <pcl_spiral/verify/impl/material_removal_engine.h>
#include <pcl_spiral/verify/impl/profile_depth.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl_spiral {

class SweepTree;
struct SweptPlaces;
struct Tangent;

/** A cutter of any profile, with its flank and a shank as wide as the flank's top, up to twice its radius above the tip or to the top
 *  of the flank, whichever is higher. On a move, the tip moves on a straight line and the axis turns evenly.
 *
 *  At each place the cutter is convex, and so is what a move without a turn of the axis sweeps: depths are then concave over the
 *  move and along a ray, and are found by their tangents. Moves on which the axis turns are halved where they may be entered until
 *  depths on a piece are about concave; there the depth is known to half a micrometre. A ray of many millimetres that grazes a move with
 *  a strong turn may enter it a little earlier. */
class ProfileSweep : public CutterSweep {
public:
  /** One tip and one unit axis per point. \p passes: points to which the cutter is lifted. */
  ProfileSweep(const CutterShape& cutter, Polyline tips, std::vector<Eigen::Vector3d> axes, const std::vector<std::size_t>& passes = {});
  ~ProfileSweep() override;

  bool enter(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const override;
  bool contains(std::size_t move, const Eigen::Vector3d& x) const override { return depth(move, x) >= 0.0; }
  double depth(std::size_t move, const Eigen::Vector3d& x) const override;
  void enterAny(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, Stock& stock) const override;
  double deepest(const Eigen::Vector3d& x) const override;
  SurfaceHeight lowest(std::size_t move, double f, const SurfaceFoot& foot, double reach) const override;

private:
  struct Piece;
  struct Depth;
  Depth depthOf(const Eigen::Vector3d& w, const Eigen::Vector3d& axis) const;
  double bound(const SweptPlaces& places, const Eigen::Vector3d& x, const Eigen::Vector3d& down) const;
  Piece whole(std::size_t move) const;
  Piece half(const Piece& piece, bool second) const;
  double bow(const Piece& piece) const;
  Tangent depthAt(const Piece& piece, double f, const Eigen::Vector3d& x, const Eigen::Vector3d& n) const;
  Tangent deepest(const Piece& piece, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double least) const;
  double firstInside(const Piece& piece, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double low, double high) const;
  double highest(const Piece& piece, const Tangent& middle, double range) const;
  bool enterPiece(const Piece& piece, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const;
  bool enterPart(const Piece& part, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const;
  void deepen(const Piece& part, const Eigen::Vector3d& x, double& most) const;

  ProfileDepth profile_;
  double height_;
  Polyline tips_;
  std::vector<Eigen::Vector3d> axes_;
  std::unique_ptr<const SweepTree> tree_;
};

/** The sweep of \p cutter along \p path. A ball without a flank needs no axes. \p tips, one per point: empty for the tips that touch at
 *  the contacts with the normals. Fails on a path without axes for another cutter, on another number of tips, and on a contact that no
 *  part of the cutter can touch. */
Status makeSweep(const CutterPath& path, const CutterShape& cutter, const Polyline& tips, std::unique_ptr<CutterSweep>& sweep);

/** What is asked of a path of \p cutter. */
RemovalSettings removalSettings(const CutterShape& cutter, double scallop_height, double chord_error, double reach);

/** Whether only the ball counts: a ball end without a flank. */
bool isBall(const CutterShape& cutter);

} // namespace pcl_spiral
