// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points near a place. Private to features.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <vector>

namespace pcl_spiral {

/** Checks the points near a place, a few at a time instead of all. */
class NearPoints {
public:
  explicit NearPoints(const Polyline& points) : points_(points)
  {
    std::vector<Eigen::Vector3f> rounded;
    rounded.reserve(points.size());
    for (const Eigen::Vector3d& p : points)
      rounded.push_back(p.cast<float>());
    if (!rounded.empty())
      blocks_ = PointBlocks(rounded);
  }

  /** Whether any point within \p reach of \p place, or slightly farther, passes the \p test(point, its number). */
  template <typename Test>
  bool any(const Eigen::Vector3d& place, double reach, Test test) const
  {
    if (points_.empty())
      return false;
    const Eigen::Vector3f rounded = place.cast<float>();
    Box box;
    box.extend(rounded.data());
    const double generous = reach * 1.001 + 1e-6 * place.cwiseAbs().maxCoeff();
    bool found = false;
    blocks_.forBlocksNear(box, static_cast<float>(generous * generous), [&](std::size_t b) {
      for (std::size_t i = blocks_.blockBegin(b); i < blocks_.blockEnd(b) && !found; ++i)
        found = test(points_[blocks_.originalIndex(i)], blocks_.originalIndex(i));
    });
    return found;
  }

private:
  const Polyline& points_;
  PointBlocks blocks_;
};

} // namespace pcl_spiral
