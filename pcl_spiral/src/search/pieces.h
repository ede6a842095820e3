// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Loops over all points in pieces of fixed size: the result does not depend on the threads. Private.
 */
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

constexpr std::size_t piece_size = 4096; ///< points that one thread takes at a time

inline std::size_t
pieceCount(std::size_t points)
{
  return (points + piece_size - 1) / piece_size;
}

/** Calls \p work(piece, begin, end) for every piece of the points, in parallel. */
template <typename Work>
void
forPieces(std::size_t points, Work work)
{
  const auto pieces = static_cast<std::int64_t>(pieceCount(points));
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t p = 0; p < pieces; ++p)
    work(static_cast<std::size_t>(p), static_cast<std::uint32_t>(p * piece_size),
         static_cast<std::uint32_t>(std::min(points, (p + 1) * piece_size)));
}

/** Calls \p work(v) for every point, pieces in parallel. */
template <typename Work>
void
forPoints(std::size_t points, Work work)
{
  forPieces(points, [&](std::size_t, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v)
      work(v);
  });
}

/** Those of \p points for which \p holds(point) is true, in their order; asked in parallel. */
template <typename Point, typename Holds>
std::vector<Point>
pointsWhere(const std::vector<Point>& points, Holds holds)
{
  std::vector<std::uint8_t> held(points.size());
  forPoints(points.size(), [&](std::uint32_t i) { held[i] = holds(points[i]); });
  std::vector<Point> chosen;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (held[i] != 0)
      chosen.push_back(points[i]);
  return chosen;
}

/** The sum of what \p add(v, sum) adds for every point: pieces in parallel, then one after the other. */
template <typename Sum, typename Add>
Sum
sumOverPoints(std::size_t points, const Sum& zero, Add add)
{
  std::vector<Sum> sums(pieceCount(points), zero);
  forPieces(points, [&](std::size_t piece, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t v = begin; v < end; ++v)
      add(v, sums[piece]);
  });
  Sum whole = zero;
  for (const Sum& sum : sums)
    whole += sum;
  return whole;
}

} // namespace pcl_spiral
