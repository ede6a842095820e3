// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/spiral_curve.h>

#include "common/freed_memory.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double closest_in_spacings = 0.4; // neighbouring lines on a turn
constexpr double widest_angle = 0.35;       // rad between neighbouring lines near the centre

/** The sense of the curve from the inside out. An inward spiral is drawn in this way too and then run from its end, which
 *  reverses its sense. */
bool
drawnClockwise(const SpiralSettings& settings)
{
  return (settings.sense == SpiralSense::Clockwise) != (settings.direction == SpiralDirection::Inward);
}

} // namespace

SpiralCurve::SpiralCurve(const std::vector<RadialLine>& lines, const TurnFunction& turns, const SpiralSettings& settings, double spacing)
: lines_(lines), turns_(turns), settings_(settings), spacing_(spacing),
  max_step_(settings.max_step > 0.0 ? settings.max_step : settings.tool_radius)
{
  findActiveShares();
}

void
SpiralCurve::setRim(Polyline rim, std::vector<std::size_t> corners)
{
  rim_ = {std::move(rim), std::move(corners), {}, true};
  meetLines(rim_);
}

void
SpiralCurve::setInner(Polyline inner, std::vector<std::size_t> corners)
{
  inner_ = {std::move(inner), std::move(corners), {}, false};
  meetLines(inner_);
}

void
SpiralCurve::meetLines(ClosedLoop& loop) const
{
  if (loop.at_rim) {
    for (const RadialLine& line : lines_)
      loop.line_shares.push_back(line.rim_share);
    loop.line_shares.push_back(1.0);
    return;
  }
  // Lines start on the inner loop in order: go round it once, from line to line, to the place nearest to each start.
  const std::size_t m = loop.points.size();
  const std::vector<double> s = arcLengths(loop.points, true);
  loop.line_shares.assign(1, 0.0);
  std::size_t from = 0;
  for (std::size_t i = 1; i < lines_.size(); ++i) {
    const Eigen::Vector3d start = lines_[i].feet.front().position;
    double best = std::numeric_limits<double>::max(), share = loop.line_shares.back();
    std::size_t found = from;
    for (std::size_t k = from; k < m && k < from + m / 2; ++k) {
      const Eigen::Vector3d d = loop.points[(k + 1) % m] - loop.points[k];
      const double f = std::clamp((start - loop.points[k]).dot(d) / d.squaredNorm(), 0.0, 1.0);
      const double distance = (loop.points[k] + f * d - start).norm();
      if (distance < best) {
        best = distance;
        found = k;
        share = (s[k] + f * (s[k + 1] - s[k])) / s[m];
      }
    }
    from = found;
    loop.line_shares.push_back(std::max(share, loop.line_shares.back()));
  }
  loop.line_shares.push_back(1.0);
}

void
SpiralCurve::findActiveShares()
{
  const std::size_t n = lines_.size();
  active_from_.assign(n, 0.0);
  int finest = 0;
  for (const RadialLine& line : lines_)
    finest = std::max(finest, line.level);
  const double closest = closest_in_spacings * spacing_;
  for (int level = 1; level <= finest; ++level)
    for (std::size_t i = 0; i < n; ++i) {
      if (lines_[i].level != level || lines_[i].corner)
        continue;
      // Its neighbours among the coarser lines, on both sides.
      std::size_t left = (i + n - 1) % n, right = (i + 1) % n;
      while (lines_[left].level >= level)
        left = (left + n - 1) % n;
      while (lines_[right].level >= level)
        right = (right + 1) % n;
      const std::size_t last = lines_[i].feet.size() - 1;
      std::size_t k = 1;
      for (; k < last; ++k) { // the first station from the centre at which the line is needed
        const auto at = [&](std::size_t line) { return lines_[line].feet[k * (lines_[line].feet.size() - 1) / last].position; };
        const double apart = (at(left) - at(i)).norm() + (at(right) - at(i)).norm();
        const double s = lines_[i].length() * static_cast<double>(k) / static_cast<double>(last);
        if (apart >= 2.0 * closest || apart >= widest_angle * s)
          break;
      }
      const double own = static_cast<double>(k - 1) / static_cast<double>(last);
      active_from_[i] = std::max({own, active_from_[left], active_from_[right]});
    }
}

std::vector<SpiralCurve::Knot>
SpiralCurve::turnKnots(std::size_t turn) const
{
  std::vector<Knot> knots;
  const std::size_t n = lines_.size();
  const bool clockwise = drawnClockwise(settings_);
  for (std::size_t step = 0; step < n; ++step) {
    const std::size_t i = clockwise ? (n - step) % n : step;
    const double delta = step == 0 ? 0.0 : clockwise ? 1.0 - lines_[i].turn_share : lines_[i].turn_share;
    const double tau = static_cast<double>(turn) + delta;
    const double s = turns_.arcLengthAt(i, tau);
    if (s < active_from_[i] * lines_[i].length())
      continue;
    knots.push_back({lines_[i].curve.positionAt(s), tau, turns_.feedStepAt(i, s), lines_[i].corner, step == 0});
  }
  return knots;
}

std::vector<SpiralCurve::Knot>
SpiralCurve::loopKnots(const ClosedLoop& loop, double turn) const
{
  const std::size_t m = loop.points.size(), n = lines_.size();
  const std::vector<double> s = arcLengths(loop.points, true);
  std::vector<std::uint8_t> corner(m, 0);
  for (const std::size_t c : loop.corners)
    corner[c] = 1;
  const bool clockwise = drawnClockwise(settings_);
  const auto feedStep = [&](std::size_t line) { return turns_.feedStepAt(line % n, loop.at_rim ? lines_[line % n].length() : 0.0); };
  std::vector<Knot> knots;
  for (std::size_t step = 0; step <= m; ++step) {
    const std::size_t k = clockwise ? m - step : step; // m is the first point again, one lap later
    const double share = s[k] / s[m];
    const auto after = std::upper_bound(loop.line_shares.begin() + 1, loop.line_shares.end() - 1, share);
    const auto line = static_cast<std::size_t>(after - loop.line_shares.begin()) - 1;
    // Turns are counted by the shares of the lines, on loops too.
    const double next = line + 1 < n ? lines_[line + 1].turn_share : 1.0;
    const double width = loop.line_shares[line + 1] - loop.line_shares[line];
    const double f = width > 0.0 ? (share - loop.line_shares[line]) / width : 0.0;
    const double delta = lines_[line].turn_share + f * (next - lines_[line].turn_share);
    knots.push_back({loop.points[k % m], turn + (clockwise ? 1.0 - delta : delta), (1.0 - f) * feedStep(line) + f * feedStep(line + 1),
                     corner[k % m] != 0 || step == 0 || step == m, false});
  }
  return knots;
}

std::vector<SpiralCurve::Knot>
SpiralCurve::turnBesideLoop(const ClosedLoop& loop, std::size_t turn) const
{
  // The distance of each line from the loop, and of line 0 again at the end of the turn.
  struct Offset {
    double gone; ///< share of the turn done so far
    Eigen::Vector3d by;
  };
  const std::size_t n = lines_.size();
  const bool clockwise = drawnClockwise(settings_);
  std::vector<Offset> offsets;
  for (std::size_t step = 0; step <= n; ++step) {
    const std::size_t i = (clockwise ? n - step : step) % n;
    const double share = lines_[i].turn_share;
    const double gone = step == 0 ? 0.0 : step == n ? 1.0 : clockwise ? 1.0 - share : share;
    const double along = turns_.arcLengthAt(i, static_cast<double>(turn) + gone);
    offsets.push_back({gone, lines_[i].curve.positionAt(along) - lines_[i].curve.positionAt(loop.at_rim ? lines_[i].length() : 0.0)});
  }
  std::vector<Knot> knots = loopKnots(loop, static_cast<double>(turn));
  std::size_t j = 0;
  for (Knot& knot : knots) {
    const double gone = knot.turn - static_cast<double>(turn);
    while (j + 2 < offsets.size() && offsets[j + 1].gone <= gone)
      ++j;
    const double f = std::clamp((gone - offsets[j].gone) / (offsets[j + 1].gone - offsets[j].gone), 0.0, 1.0);
    knot.position += (1.0 - f) * offsets[j].by + f * offsets[j + 1].by;
  }
  return knots;
}

std::vector<SpiralCurve::Knot>
SpiralCurve::knots() const
{
  const auto count = static_cast<std::int64_t>(turns_.turns());
  const bool two = !inner_.points.empty();
  std::vector<std::vector<Knot>> parts(count + 2);
  if (two)
    parts.front() = loopKnots(inner_, -1.0);
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t j = 0; j < count; ++j)
    parts[j + 1] = turnKnots(j);
  // The turns next to a loop follow it, so that they cannot cross it however close they come.
  if (two)
    parts[1] = turnBesideLoop(inner_, 0);
  if (count > 1)
    parts[count] = turnBesideLoop(rim_, count - 1);
  parts.back() = loopKnots(rim_, static_cast<double>(count));
  std::size_t total = 0;
  for (const auto& part : parts)
    total += part.size();
  std::vector<Knot> all;
  all.reserve(total);
  for (auto& part : parts) {
    for (const Knot& knot : part) {
      // The end of one part is the start of the next; near the centre lines coincide.
      if (!all.empty() && (knot.position - all.back().position).norm() < 1e-6 * spacing_) {
        all.back().corner = all.back().corner || knot.corner;
        all.back().anchor = all.back().anchor || knot.anchor;
        continue;
      }
      all.push_back(knot);
      all.back().turn += two ? 1.0 : 0.0;
    }
    std::vector<Knot>().swap(part);
  }
  returnFreedMemory();
  return all;
}

} // namespace pcl_spiral
