// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Moves a cutter down along its axis onto points.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {

/** Places in the frame of a tool axis: across it, measured from the axis; along it, measured from a point on it. */
struct AxisFrame {
  Eigen::Vector3d origin, e1, e2, axis;

  /** \p axis unit. */
  AxisFrame(const Eigen::Vector3d& through, const Eigen::Vector3d& axis) : origin(through), axis(axis) { tangentFrame(axis, e1, e2); }
  Eigen::Vector2d across(const Eigen::Vector3d& p) const { return {e1.dot(p - origin), e2.dot(p - origin)}; }
  double along(const Eigen::Vector3d& p) const { return axis.dot(p - origin); }
  Eigen::Vector3d place(const Eigen::Vector2d& x, double h) const { return origin + x.x() * e1 + x.y() * e2 + h * axis; }
};

/** A box in the frame of a tool axis. */
struct AxisBox {
  double nearest = 0.0;         ///< lower bound of the distance of its places to the axis
  double low = 0.0, high = 0.0; ///< along the axis
};

/** Puts boxes into the frame of an axis. The frame must outlive it. */
class AxisView {
public:
  explicit AxisView(const AxisFrame& frame) : frame_(frame), a1_(frame.e1.cwiseAbs()), a2_(frame.e2.cwiseAbs()), a3_(frame.axis.cwiseAbs())
  {}

  AxisBox see(const Box& box) const
  {
    const Eigen::Vector3d lower(box.low[0], box.low[1], box.low[2]), upper(box.high[0], box.high[1], box.high[2]);
    const Eigen::Vector3d half = 0.5 * (upper - lower), middle = 0.5 * (upper + lower);
    const Eigen::Vector2d x = frame_.across(middle);
    const double dx = std::max(0.0, std::abs(x.x()) - half.dot(a1_)), dy = std::max(0.0, std::abs(x.y()) - half.dot(a2_));
    const double along = frame_.along(middle), reach = half.dot(a3_);
    return {std::sqrt(dx * dx + dy * dy), along - reach, along + reach};
  }

private:
  const AxisFrame& frame_;
  Eigen::Vector3d a1_, a2_, a3_;
};

/** The first contact of a cutter that moves down along its axis. */
struct DropContact {
  bool found = false;                                       ///< false: no point within the cutter's radius of the axis
  double height = -std::numeric_limits<double>::infinity(); ///< of the tip along the axis, from the frame's origin
  std::uint32_t point = 0;                                  ///< in the order of the blocks
};

/** Finds the points under a cutter by exact search: it skips a box of points only if the box
 *  is beyond the cutter's radius, or too low to be touched. The blocks must outlive it. */
class CutterDrop {
public:
  /** The cutter comes from \p ceiling along the axis, measured from the frame's origin: points above it do not count. */
  CutterDrop(const PointBlocks& blocks, const CutterProfile& profile, double ceiling = std::numeric_limits<double>::infinity())
  : blocks_(blocks), profile_(profile), ceiling_(ceiling)
  {}

  const PointBlocks& blocks() const { return blocks_; }
  const CutterProfile& profile() const { return profile_; }

  /** The location without gouge: of all points within R of the axis and not above the ceiling, the highest foot on the
   *  axis minus the height of the profile. Only points that hold the tip above \p floor count. */
  DropContact highest(const AxisFrame& frame, double floor = -std::numeric_limits<double>::infinity()) const
  {
    DropContact best;
    best.height = floor;
    visitAbove(frame, best.height, [&](std::uint32_t i, double height) {
      if (height > best.height) {
        best.found = true;
        best.height = height;
        best.point = i;
      }
    });
    return best;
  }

  /** Calls \p visit(point, height) for all points that hold the tip at \p floor or above, and
   *  for some others below. \p floor is read again each time, so \p visit may raise it. */
  template <typename Visit>
  void visitAbove(const AxisFrame& frame, const double& floor, Visit visit) const
  {
    constexpr double slack = 1e-9; // rounding never skips a point
    const AxisView view(frame);
    const double R = profile_.radius();
    const auto keep = [&](const Box& box) {
      const AxisBox seen = view.see(box);
      const double nearest = std::max(0.0, seen.nearest - slack);
      return nearest <= R && seen.low - slack <= ceiling_ && std::min(seen.high, ceiling_) - profile_.height(nearest) + slack >= floor;
    };
    blocks_.forBlocks(keep, [&](std::size_t block) {
      for (std::size_t i = blocks_.blockBegin(block); i < blocks_.blockEnd(block); ++i) {
        const Eigen::Vector3d p = blocks_.position(i);
        const double l = frame.across(p).norm(), along = frame.along(p);
        if (l <= R && along <= ceiling_)
          visit(static_cast<std::uint32_t>(i), along - profile_.height(l));
      }
    });
  }

private:
  const PointBlocks& blocks_;
  CutterProfile profile_;
  double ceiling_;
};

} // namespace pcl_spiral
