// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Drops a cutter onto the surface fitted to a scan.
 */
#pragma once

#include <pcl_spiral/cutter/impl/cutter_drop.h>
#include <pcl_spiral/cutter/impl/location_surface.h>

#include <vector>

namespace pcl_spiral {

/** Where a cutter that moves down along its axis meets the fitted surface. */
struct FittedContact {
  bool found = false;  ///< false if no fit is reliable, or the surface is nearly parallel to the axis
  bool beyond = false; ///< not found, and the cutter would touch where no points are, or farther beyond them than a fit is reliable
  double height = 0.0; ///< of the tip along the axis, from the frame's origin
  Eigen::Vector3d contact = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< unit, to the side the tool is on
  double gap_bound = 0.0;                           ///< how far the cutter may sink here between the points, see samplingGap
  double normal_share = 1.0;                        ///< cosine between normal and axis
};

/** Refines the contact of a cutter with the points to its contact with the moving-least-squares surface.
 *
 *  It starts from up to four of the points met first, well apart; of a scan with noise, from their places on the fit. The surface about
 *  each is the quadric of its fit; the contact with the quadric is found, the fit is repeated there, and so on until the contact
 *  converges. The highest contact counts. */
class FittedDrop {
public:
  FittedDrop(const LocationSurface& surface, const CutterProfile& profile, double ceiling)
  : surface_(surface), profile_(profile), ceiling_(ceiling), drop_(surface.obstacles(), profile, ceiling)
  {}

  /** One contact a frame. \p drops: the drops of the same frames on the points only. */
  void locate(const std::vector<AxisFrame>& frames, const std::vector<DropContact>& drops, std::vector<FittedContact>& contacts) const;

  /** How far the cutter may sink between the points around \p foot, where it touches, along the axis of \p frame. */
  double gapBound(const AxisFrame& frame, const SurfaceFoot& foot) const;

private:
  struct Start;
  void findStarts(const AxisFrame& frame, const DropContact& drop, Start* starts) const;
  void step(const AxisFrame& frame, const SurfaceFoot& foot, Start& start) const;

  const LocationSurface& surface_;
  CutterProfile profile_;
  double ceiling_;
  CutterDrop drop_;
};

} // namespace pcl_spiral
