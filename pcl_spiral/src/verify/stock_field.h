// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Stock over places of a surface under a swept cutter, and the tops of its ridges. Private to verify.
 */
#pragma once

#include <pcl_spiral/verify/impl/cutter_sweep.h>

#include <cstddef>

namespace pcl_spiral {

/** The top of a ridge. */
struct Ridge {
  double height = 0.0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< on the surface below it
  std::size_t move = 0;
  bool found = false;
};

/** Position and normal of the surface. */
struct SurfacePlace {
  Eigen::Vector3d position, normal;
};

/** The quadric about \p foot, at \p d in its tangent plane. */
SurfacePlace placeAt(const SurfaceFoot& foot, const Eigen::Vector3d& d);

/** A foot at that place, with the same curvatures. */
SurfaceFoot shifted(const SurfaceFoot& foot, const Eigen::Vector3d& d);

class StockField {
public:
  /** Rays reach \p reach above the surface. They start \p shallow below it, or deep inside the cutter if
   *  that is not deep enough. */
  StockField(const CutterSweep& sweep, double shallow, double reach) : sweep_(sweep), shallow_(shallow), reach_(reach) {}

  /** Stock over a place: the smallest t at which x + t n lies in the swept solid; the reach if there is none. \p guess: the move tried
   *  first. */
  Stock at(const Eigen::Vector3d& x, const Eigen::Vector3d& n, std::size_t guess) const;

  /** Unit direction across the feed of \p move at \p foot; zero where the move is along the surface normal. */
  Eigen::Vector3d across(const SurfaceFoot& foot, std::size_t move) const;

  /** The top of the first ridge from \p foot in the direction \p w, across the feed, within \p limit, in
   *  steps of \p step. The stock is the least over the moves, each of which leaves a hollow. The ridge is where
   *  two hollows meet; it is found on these moves and confirmed against all moves. */
  Ridge climbed(const SurfaceFoot& foot, const Stock& from, const Eigen::Vector3d& w, double step, double limit) const;
  /** The same, on the side that rises. */
  Ridge climbed(const SurfaceFoot& foot, const Stock& from, double step, double limit) const;

private:
  Stock cast(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, std::size_t guess) const;
  /** Height of the stock that \p move leaves by itself, up to twice the reach. */
  double under(std::size_t move, const SurfacePlace& place) const;
  /** The place in [low, high] at which the stock of two moves has the same height. */
  double meeting(const SurfaceFoot& foot, const Eigen::Vector3d& w, std::size_t first, std::size_t second, double low, double high) const;

  const CutterSweep& sweep_;
  double shallow_, reach_;
};

} // namespace pcl_spiral
