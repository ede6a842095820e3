// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The points of a front, by rising distance.
 */
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Points to visit, by distance in steps of a given width. */
class BucketQueue {
public:
  BucketQueue(double width, std::size_t buckets) : width_(width), buckets_(buckets) {}

  void push(std::uint32_t point, double distance);
  /** Takes the nearest bucket that is not empty, in the order it was filled; false if there is none. An entry may be
   *  out of date. */
  bool pop(std::vector<std::uint32_t>& points);

private:
  double width_;
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::size_t current_ = 0, waiting_ = 0;
};

} // namespace pcl_spiral
