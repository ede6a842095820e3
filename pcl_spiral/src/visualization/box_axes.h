// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Position of the axes of a picture.
 */
#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

namespace pcl_spiral {

constexpr int number_size = 18, name_size = 20; ///< of the text at the axes, pixels

/** A parallel view: the directions of the picture in the scene, unit and perpendicular, and its scale. */
struct ParallelView {
  Eigen::Vector3d right, top;
  double mm_per_pixel = 1.0;

  /** Position of a place in the picture, pixels right of and above the origin. */
  Eigen::Vector2d project(const Eigen::Vector3d& place) const { return Eigen::Vector2d(right.dot(place), top.dot(place)) / mm_per_pixel; }
  /** Direction from the scene to the viewer, unit. */
  Eigen::Vector3d towards() const { return right.cross(top); }
};

/** Text in a picture; pixels. */
struct AxisText {
  std::string words;
  int font_size;
  Eigen::Vector2d middle;
  Eigen::Vector2d half_size; ///< an upper bound
};

/** One axis in the picture; pixels, as from ParallelView::project. */
struct BoxAxis {
  int axis; ///< 0, 1, 2: x, y, z
  Eigen::Vector2d from, to;
  Eigen::Vector2d outward;            ///< unit, away from the box
  std::vector<Eigen::Vector2d> ticks; ///< start points on the axis
  std::vector<AxisText> texts;        ///< the name of the axis, then its numbers, mm
};

/** Step between numbers of an axis: 1, 2 or 5 times a power of ten, at least \p least. */
double niceStep(double least);

/** Length of a tick, pixels. */
constexpr double axis_tick_length = 9.0;

/** Axes along edges of the box from \p low to \p high, mm.
 *
 *  Each runs along the outline of the box in the view, so that nothing covers the part. There are up to 64
 *  ways to choose such edges. The chosen one has, if the view allows it, no overlaps, flat axes below, steep axes
 *  on different sides, and axes that meet in a corner. Numbers that still overlap are left out. An
 *  edge seen nearly end on (less than 40 pixels) gets no axis. */
std::vector<BoxAxis> layOutAxes(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const ParallelView& view);

} // namespace pcl_spiral
