// SPDX-License-Identifier: BSD-3-Clause
#include "level_lines.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** For each level, the triangles it crosses, ascending. */
struct CrossedTriangles {
  std::vector<std::size_t> begin; ///< of each level, and the end
  std::vector<std::uint32_t> triangles;
};

/** Calls visit(first, end) with the levels that cross triangle t, if any. */
template <typename Visit>
void
forLevels(const Triangulation& mesh, const std::vector<double>& values, const std::vector<double>& levels, std::size_t t, Visit visit)
{
  const auto& corner = mesh.triangle(t);
  const double a = values[corner[0]], b = values[corner[1]], c = values[corner[2]];
  if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c))
    return;
  const auto first = std::upper_bound(levels.begin(), levels.end(), std::min({a, b, c}));
  const auto end = std::upper_bound(first, levels.end(), std::max({a, b, c}));
  visit(static_cast<std::size_t>(first - levels.begin()), static_cast<std::size_t>(end - levels.begin()));
}

CrossedTriangles
crossedTriangles(const Triangulation& mesh, const std::vector<double>& values, const std::vector<double>& levels)
{
  CrossedTriangles crossed;
  crossed.begin.assign(levels.size() + 1, 0);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    forLevels(mesh, values, levels, t, [&](std::size_t first, std::size_t end) {
      for (std::size_t k = first; k < end; ++k)
        ++crossed.begin[k + 1];
    });
  for (std::size_t k = 0; k < levels.size(); ++k)
    crossed.begin[k + 1] += crossed.begin[k];
  crossed.triangles.resize(crossed.begin.back());
  std::vector<std::size_t> next(crossed.begin.begin(), crossed.begin.end() - 1);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    forLevels(mesh, values, levels, t, [&](std::size_t first, std::size_t end) {
      for (std::size_t k = first; k < end; ++k)
        crossed.triangles[next[k]++] = static_cast<std::uint32_t>(t);
    });
  return crossed;
}

/** Follows the lines of one level. */
class LevelTracer {
public:
  LevelTracer(const Triangulation& mesh, const std::vector<double>& values, double level, const std::uint32_t* begin,
              const std::uint32_t* end)
  : mesh_(mesh), values_(values), level_(level), begin_(begin), end_(end), seen_(end - begin, 0), starts_(end - begin, 1),
    after_(end - begin, none)
  {
    for (std::size_t i = 0; i < starts_.size(); ++i)
      if (const std::size_t before = indexOf(mesh_.opposite(sideOf(begin_[i], false))); before != none) {
        starts_[i] = 0;
        after_[before] = static_cast<std::uint32_t>(i);
      }
  }

  std::vector<LevelLine> lines()
  {
    std::vector<LevelLine> lines;
    for (const bool open : {true, false})
      for (std::size_t i = 0; i < seen_.size(); ++i)
        if (!seen_[i] && (!open || starts_[i]))
          lines.push_back(follow(i));
    return lines;
  }

private:
  static constexpr std::uint32_t none = 0xffffffffu;

  bool isAbove(std::uint32_t point) const { return values_[point] >= level_; }
  /** The half-edge of a crossed triangle that runs up through the level, or down. The line enters through the one
   * that runs down. */
  std::uint32_t sideOf(std::uint32_t triangle, bool up) const
  {
    std::uint32_t h = 3 * triangle;
    while (isAbove(mesh_.origin(h)) == up || isAbove(mesh_.target(h)) != up)
      ++h;
    return h;
  }
  LevelCrossing crossing(std::uint32_t h) const
  {
    LevelCrossing c{mesh_.origin(h), mesh_.target(h), 0.0, h};
    if (isAbove(c.below))
      std::swap(c.below, c.above);
    c.share = (level_ - values_[c.below]) / (values_[c.above] - values_[c.below]);
    return c;
  }
  /** Index of the triangle of half-edge \p h among those crossed, if it is one of them. */
  std::size_t indexOf(std::uint32_t h) const
  {
    if (h == Triangulation::none)
      return none;
    const std::uint32_t* at = begin_; // the last that is not beyond the triangle; halved without branches, which could not be foreseen
    for (std::size_t count = end_ - begin_, half; count > 1; count -= half) {
      half = count / 2;
      at += at[half] <= h / 3 ? half : 0;
    }
    return *at == h / 3 ? static_cast<std::size_t>(at - begin_) : none;
  }
  LevelLine follow(std::size_t first)
  {
    LevelLine line;
    line.crossings.push_back(crossing(sideOf(begin_[first], false)));
    for (std::size_t at = first; at != none; at = after_[at]) {
      seen_[at] = 1;
      line.closed = after_[at] == first;
      if (line.closed)
        break;
      line.crossings.push_back(crossing(sideOf(begin_[at], true)));
    }
    return line;
  }

  const Triangulation& mesh_;
  const std::vector<double>& values_;
  double level_;
  const std::uint32_t *begin_, *end_;
  std::vector<std::uint8_t> seen_, starts_; ///< one a crossed triangle: whether a line begins there
  std::vector<std::uint32_t> after_;        ///< index of the next triangle of its line
};

} // namespace

std::vector<std::vector<LevelLine>>
levelLines(const Triangulation& mesh, const std::vector<double>& values, const std::vector<double>& levels)
{
  const CrossedTriangles crossed = crossedTriangles(mesh, values, levels);
  std::vector<std::vector<LevelLine>> lines(levels.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(levels.size()); ++k)
    lines[k] =
        LevelTracer(mesh, values, levels[k], crossed.triangles.data() + crossed.begin[k], crossed.triangles.data() + crossed.begin[k + 1])
            .lines();
  return lines;
}

std::vector<LevelLine>
levelLines(const Triangulation& mesh, const std::vector<double>& values, double level, const std::vector<std::uint32_t>& triangles)
{
  const std::vector<double> levels{level};
  std::vector<std::uint32_t> crossed;
  for (const std::uint32_t t : triangles)
    forLevels(mesh, values, levels, t, [&](std::size_t first, std::size_t end) {
      if (end > first)
        crossed.push_back(t);
    });
  return LevelTracer(mesh, values, level, crossed.data(), crossed.data() + crossed.size()).lines();
}

Polyline
pointsOf(const LevelLine& line, const PointBlocks& points)
{
  Polyline all;
  all.reserve(line.crossings.size());
  for (const LevelCrossing& c : line.crossings)
    all.push_back((1.0 - c.share) * points.position(c.below) + c.share * points.position(c.above));
  return all;
}

} // namespace pcl_spiral
