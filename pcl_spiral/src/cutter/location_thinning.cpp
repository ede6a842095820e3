// SPDX-License-Identifier: BSD-3-Clause
#include "location_thinning.h"

#include <algorithm>
#include <cstddef>

namespace pcl_spiral {
namespace {

constexpr std::size_t longest_run = 256; // of consecutive places left out, so that the time stays linear

/** Upper bound of the distance between a point of the cutter at \p place and its nearest position on the way from \p a to \p b. */
double
offTheWay(const CutterPlace& a, const CutterPlace& b, const CutterPlace& place, double reach)
{
  const Eigen::Vector3d way = b.tip - a.tip, turn = b.axis - a.axis;
  const Eigen::Vector3d tip = place.tip - a.tip, axis = place.axis - a.axis;
  const double whole = way.squaredNorm() + reach * reach * turn.squaredNorm();
  const double t = whole > 0.0 ? std::clamp((tip.dot(way) + reach * reach * axis.dot(turn)) / whole, 0.0, 1.0) : 0.0;
  return (tip - t * way).norm() + reach * (axis - t * turn).norm();
}

/** The largest distance of the places between \p from and \p to; infinite as soon as it is over \p limit. */
double
largestOff(const std::vector<CutterPlace>& places, std::size_t from, std::size_t to, double reach, double limit)
{
  double largest = 0.0;
  for (std::size_t k = from + 1; k < to && largest <= limit; ++k)
    largest = std::max(largest, offTheWay(places[from], places[to], places[k], reach));
  return largest;
}

} // namespace

std::vector<std::uint8_t>
keptPlaces(const std::vector<CutterPlace>& places, const std::vector<std::uint8_t>& needed, double reach, double tolerance, double& largest)
{
  std::vector<std::uint8_t> kept(places.size(), 0);
  for (std::size_t from = 0; from < places.size();) {
    kept[from] = 1;
    std::size_t to = from + 1;
    double off = 0.0;
    while (to + 1 < places.size() && !needed[to] && to - from < longest_run) {
      const double next = largestOff(places, from, to + 1, reach, tolerance);
      if (next > tolerance)
        break;
      off = next;
      ++to;
    }
    largest = std::max(largest, off);
    from = to;
  }
  return kept;
}

} // namespace pcl_spiral
