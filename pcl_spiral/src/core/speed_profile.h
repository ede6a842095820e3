// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Speeds and times along a row of straight elements.
 */
#pragma once

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A line or an arc. */
struct MotionElement {
  double length = 0.0;
  double speed = 0.0;        ///< the largest
  double acceleration = 0.0; ///< along it
  double jerk = 0.0;         ///< along it; infinity: no limit
  double exit = 0.0;         ///< the largest speed at its end
  std::size_t first = 0;     ///< the move that its first half belongs to
  std::size_t second = 0;    ///< and its second half
};

/** When an element runs. */
struct ElementTime {
  double seconds = 0.0;
  double rise = 0.0; ///< of these, from the entry to the largest speed
  double fall = 0.0; ///< and from there to the exit
};

/** The times of elements that run from stop to stop; the control knows \p look_ahead of them, and assumes a stop behind. */
std::vector<ElementTime> elementTimes(const std::vector<MotionElement>& elements, std::size_t look_ahead);

} // namespace pcl_spiral
