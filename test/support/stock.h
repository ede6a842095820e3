// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Stock over exact surface samples under a swept ball, and the search for the tops of ridges. Lengths in
 * mm.
 */
#pragma once

#include "support/move_tree.h"
#include "support/surfaces.h"

#include <cstddef>

namespace pcl_spiral::test {

/** A surface sample and the stock over it; the stock is not_counted if the sample was left out. */
struct StockSample {
  static constexpr double not_counted = -1e9;
  Eigen::Vector3d x;
  double stock = not_counted;
  std::size_t move = 0; ///< the move that cuts there
  bool met = false;     ///< false: nothing cuts there inside the reach
};

/** The stock that the ball swept along the moves of its centre leaves on a surface. */
class StockField {
public:
  /** \p band: width at the outline that the searches leave out. Rays reach 20 \p h. */
  StockField(const AnalyticSurface& surface, const MoveTree& centres, double radius, double h, double band)
  : surface_(surface), tree_(centres), radius_(radius), h_(h), band_(band)
  {}

  /** Whether the point is inside the outline and outside the band. */
  bool main(const Eigen::Vector3d& x) const;
  /** Stock over a point of the surface. */
  StockSample at(const Eigen::Vector3d& x) const;
  /** Stock over the surface at a distance \p d along \p w from a sample, left out if not in the main area. */
  StockSample off(const StockSample& from, const Eigen::Vector3d& w, double d, bool near_rim) const;
  /** Unit direction across the feed at a sample: along the surface, normal to the move that cuts there. */
  Eigen::Vector3d across(const StockSample& s) const;
  /** Exact step-over along \p w. */
  double pitch(const StockSample& s, const Eigen::Vector3d& w) const;
  /** The top of the ridge that rises from the sample, across the feed. */
  StockSample climbed(const StockSample& start) const;
  /** The highest place of the ridge within the length of a move both ways. */
  StockSample followed(const StockSample& ridge) const;

private:
  /** Golden section for the largest stock between the offsets \p lo and \p hi along \p w. */
  StockSample golden(const StockSample& from, const Eigen::Vector3d& w, double lo, double hi, bool near_rim, int rounds) const;

  const AnalyticSurface& surface_;
  const MoveTree& tree_;
  double radius_, h_, band_;
};

} // namespace pcl_spiral::test
