// SPDX-License-Identifier: BSD-3-Clause
#include "station_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr std::size_t run = 32; // stations in a ball

} // namespace

StationLine::StationLine(const SmoothLine& line, double step, std::size_t extra) : extra_(line.closed() ? 0 : extra), closed_(line.closed())
{
  const auto pieces = static_cast<std::size_t>(std::max(4.0, std::ceil(line.length() / step)));
  step_ = line.length() / static_cast<double>(pieces);
  const std::size_t count = closed_ ? pieces : pieces + 1 + 2 * extra_;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = s(i), within = closed_ ? at : std::clamp(at, 0.0, line.length());
    tangents_.push_back(line.tangent(within));
    positions_.push_back(line.position(within) + (at - within) * tangents_.back());
  }
  addBalls();
}

void
StationLine::addBalls()
{
  for (std::size_t begin = 0; begin < size(); begin += run) {
    const std::size_t end = std::min(size(), begin + run);
    Ball ball{positions_[(begin + end) / 2], 0.0};
    for (std::size_t i = begin; i < end; ++i)
      ball.radius = std::max(ball.radius, (positions_[i] - ball.centre).norm());
    balls_.push_back(ball);
  }
}

std::uint32_t
StationLine::nearestStation(const Eigen::Vector3d& p, double reach) const
{
  double least = reach * reach;
  auto best = static_cast<std::uint32_t>(size());
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    if ((p - balls_[b].centre).norm() - balls_[b].radius > std::sqrt(least))
      continue;
    for (std::size_t i = b * run; i < std::min(size(), (b + 1) * run); ++i)
      if (const double d = (p - positions_[i]).squaredNorm(); d < least) {
        least = d;
        best = static_cast<std::uint32_t>(i);
      }
  }
  return best;
}

LineFoot
StationLine::foot(const Eigen::Vector3d& p, std::uint32_t& station) const
{
  const std::size_t segments = closed_ ? size() : size() - 1;
  std::size_t i = std::min<std::size_t>(station, segments - 1);
  int way = 0; // one direction only: if the line bends about p, the search could go back and forth for ever
  LineFoot foot;
  for (std::size_t count = 0; count < segments; ++count) {
    const bool behind = ahead(p, i) < 0.0, beyond = !behind && ahead(p, (i + 1) % size()) > 0.0;
    if (!behind && !beyond)
      break;
    const int next = behind ? -1 : 1;
    if (way == -next || (!closed_ && (behind ? i == 0 : i + 1 == segments)))
      break;
    way = next;
    i = (i + segments + static_cast<std::size_t>(next + static_cast<int>(segments))) % segments;
  }
  station = static_cast<std::uint32_t>(i);
  const std::size_t j = (i + 1) % size();
  const double before = ahead(p, i), after = -ahead(p, j);
  foot.inside = before >= 0.0 && after >= 0.0 && before + after > 0.0;
  const double t = foot.inside ? before / (before + after) : (before < 0.0 ? 0.0 : 1.0);
  foot.s = s(i) + t * step_;
  const double a = t * t * (3.0 - 2.0 * t), b = t * (1.0 - t) * (1.0 - t) * step_, c = t * t * (t - 1.0) * step_;
  foot.position = (1.0 - a) * positions_[i] + a * positions_[j] + b * tangents_[i] + c * tangents_[j];
  foot.tangent = ((1.0 - t) * tangents_[i] + t * tangents_[j]).normalized();
  return foot;
}

} // namespace pcl_spiral
