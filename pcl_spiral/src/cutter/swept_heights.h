// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Heights that passes of any cutter leave over places of a surface. Private.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/impl/swept_error.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl_spiral {

/** What a cutter cuts on straight moves, with axes that turn evenly along each. */
class SweptHeights {
public:
  /** One list of places per pass; between passes nothing is cut. The tool is \p length long, mm. */
  SweptHeights(const CutterProfile& profile, double length, const std::vector<std::vector<CutterPlace>>& passes);

  /** Least height above \p x along \p normal (unit) that is cut, mm, from -\p most; \p most if none is below it. */
  double over(const Eigen::Vector3d& x, const Eigen::Vector3d& normal, double most) const;

  /** Distance of \p x from what is cut, mm, up to \p most; 0 in it. In a corner that the cutter does not reach this is the material left,
   *  where the height along a wall's normal is the way along the wall beside it. */
  double distance(const Eigen::Vector3d& x, double most) const;

private:
  struct Move {
    CutterPlace from, to;
  };
  using Cell = std::array<std::int64_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };

  Cell cellOf(const Eigen::Vector3d& x) const;
  bool cuts(const Move& move, const Eigen::Vector3d& x) const;
  double distance(const Move& move, const Eigen::Vector3d& x) const;
  /** \p visit gets the number of each move that may cut near \p x. */
  template <typename Visit>
  void visitNear(const Eigen::Vector3d& x, const Visit& visit) const;

  CutterProfile profile_;
  double length_;
  std::vector<Move> moves_;
  double cell_ = 0.0; ///< mm
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
};

} // namespace pcl_spiral
