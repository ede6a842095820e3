// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Range maps of folded parts, as a depth camera at one place sees them.
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <functional>

namespace pcl_spiral::test {

/** Kinds of parts, about 150 mm across; overhangs, folds and unseen steps are in all of them. */
enum class FoldedPart {
  Bust,    ///< a head on shoulders
  Hand,    ///< five fingers
  Bracket, ///< two plates with a gusset, holes and a screw
  Casting  ///< a plate with ribs, bosses and a pocket
};

/** A part by its signed distance: less than 0 inside, nowhere farther from the surface than it says. */
using SignedDistance = std::function<double(const Eigen::Vector3d&)>;

/** One of the parts of a kind; \p seed chooses its sizes and how it is turned to the camera. */
SignedDistance foldedPart(FoldedPart kind, unsigned int seed);

/** What a camera at (0, 0, 500) sees of \p part: an organized cloud of 256 by 256 rays over 200 mm, NaN where a ray meets nothing and for
 *  one point in a hundred. \p noise, mm, along the ray, and a ripple of 0.7 of that across the picture. */
pcl::PointCloud<pcl::PointXYZ>::Ptr rangeView(const SignedDistance& part, double noise, unsigned int seed);

} // namespace pcl_spiral::test
