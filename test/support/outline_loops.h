// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Closed outlines to test paths: necks, arms, slits, bands. Counter-clockwise, mm.
 */
#pragma once

#include "support/region.h"

#include <Eigen/Core>

#include <functional>

namespace pcl_spiral::test {

/** |x / a|^power + |y / b|^power = 1: an ellipse at power 2, a rounded rectangle above. */
PlaneLoop superellipse(double a, double b, double power, std::size_t count = 4096);
/** Two discs of \p radius about (-apart, 0) and (apart, 0), joined by a neck of width 2 \p neck. */
PlaneLoop dumbbell(double radius, double apart, double neck, std::size_t count = 4096);
/** A cross of size \p size with arms \p arm wide. */
PlaneLoop cross(double size, double arm);
/** A star without corners: radius + swing cos(tips t) about the origin. */
PlaneLoop smoothStar(int tips, double radius, double swing, std::size_t count = 4096);
/** A U open at the top: its limbs and its floor are \p limb wide. */
PlaneLoop uShape(double width, double height, double limb);
/** A band along the circle of \p radius, \p width wide over \p degrees, with half circles as ends. */
PlaneLoop band(double radius, double width, double degrees, std::size_t count = 4096);
/** A disc with a slit from the right rim to the centre, \p width wide, with a half circle as end. */
PlaneLoop slitDisc(double radius, double width, std::size_t count = 4096);

/** The loop with edges no longer than \p longest, every vertex moved by \p f. */
PlaneLoop bent(const PlaneLoop& loop, double longest, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& f);

} // namespace pcl_spiral::test
