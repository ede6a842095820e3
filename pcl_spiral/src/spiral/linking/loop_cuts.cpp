// SPDX-License-Identifier: BSD-3-Clause
#include "loop_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {

void
PathPiece::add(const Eigen::Vector3d& p, const StepOverMetric& m)
{
  points.push_back(p);
  metric.push_back(m);
}

void
PathPiece::reverse()
{
  std::reverse(points.begin(), points.end());
  std::reverse(metric.begin(), metric.end());
}

std::size_t
CutLoops::addCut(const LoopCut& cut)
{
  cuts_.push_back(cut);
  cuts_.back().begin = loops_[cut.loop].wrapped(cut.begin);
  connectors_.resize(2 * cuts_.size());
  auto& cuts = cuts_of_[cut.loop];
  cuts.push_back(cuts_.size() - 1);
  std::sort(cuts.begin(), cuts.end(), [this](std::size_t a, std::size_t b) { return cuts_[a].begin < cuts_[b].begin; });
  return cuts_.size() - 1;
}

void
CutLoops::connect(const CutEnd& from, const CutEnd& to, PathPiece piece)
{
  const std::size_t a = 2 * from.cut + from.at_end, b = 2 * to.cut + to.at_end;
  connectors_[a] = {b, pieces_.size(), false};
  connectors_[b] = {a, pieces_.size(), true};
  pieces_.push_back(std::move(piece));
}

bool
CutLoops::isFree(std::size_t loop, double u, double reach) const
{
  const double whole = loops_[loop].length();
  for (const std::size_t c : cuts_of_[loop]) {
    const double after = loops_[loop].wrapped(u - cuts_[c].begin);
    if (after < cuts_[c].length + reach || whole - after < reach)
      return false;
  }
  return true;
}

double
CutLoops::freeBehind(std::size_t loop, double u, double limit) const
{
  double free = limit;
  for (const std::size_t c : cuts_of_[loop]) {
    const double after = loops_[loop].wrapped(u - cuts_[c].begin);
    free = std::min(free, std::max(0.0, after - cuts_[c].length));
  }
  return free;
}

void
CutLoops::addArc(std::size_t loop, double from, double length, bool backward, LinkedPath& path) const
{
  const ScallopLoop& line = loops_[loop];
  PathPiece piece;
  piece.add(line.at(from), line.metricAt(from));
  const double begin = line.wrapped(from);
  auto i = static_cast<std::size_t>(std::upper_bound(line.arcs.begin(), line.arcs.end() - 1, begin) - line.arcs.begin());
  for (std::size_t steps = 0; steps < line.points.size(); ++steps, ++i) {
    const std::size_t at = i % line.points.size();
    const double after = line.wrapped(line.arcs[at] - begin);
    if (after >= length - 1e-9)
      break;
    if (after > 1e-9)
      piece.add(line.points[at], line.metric[at]);
  }
  piece.add(line.at(from + length), line.metricAt(from + length));
  if (backward)
    piece.reverse();
  path.points.insert(path.points.end(), piece.points.begin(), piece.points.end());
  path.metric.insert(path.metric.end(), piece.metric.begin(), piece.metric.end());
  path.reversed.resize(path.points.size(), backward);
  const double before = path.turns.empty() ? 0.0 : path.turns.back();
  for (std::size_t k = 0; k < piece.points.size(); ++k)
    path.turns.push_back(
        static_cast<float>(before + length / line.length() * static_cast<double>(k) / static_cast<double>(piece.points.size() - 1)));
}

std::size_t
CutLoops::walk(const CutEnd& start, LinkedPath& path) const
{
  std::size_t end = 2 * start.cut + start.at_end, arcs = 0;
  while (arcs <= cuts_.size()) {
    const LoopCut& cut = cuts_[end / 2];
    const bool backward = end % 2 == 0;
    const auto& row = cuts_of_[cut.loop];
    const std::size_t at = static_cast<std::size_t>(std::find(row.begin(), row.end(), end / 2) - row.begin());
    const std::size_t other = row[(at + (backward ? row.size() - 1 : 1)) % row.size()];
    const LoopCut &first = cuts_[backward ? other : end / 2], &second = cuts_[backward ? end / 2 : other];
    const ScallopLoop& line = loops_[cut.loop];
    double length = line.wrapped(second.begin - first.begin) - first.length;
    if (other == end / 2)
      length = line.length() - first.length;
    addArc(cut.loop, first.begin + first.length, length, backward, path);
    ++arcs;
    const Connector& connector = connectors_[2 * other + (backward ? 1 : 0)];
    if (connector.to == none)
      break;
    PathPiece piece = pieces_[connector.piece];
    if (connector.reversed)
      piece.reverse();
    path.points.insert(path.points.end(), piece.points.begin(), piece.points.end());
    path.metric.insert(path.metric.end(), piece.metric.begin(), piece.metric.end());
    path.reversed.resize(path.points.size(), backward);
    path.turns.resize(path.points.size(), path.turns.back());
    end = connector.to;
  }
  return arcs;
}

} // namespace pcl_spiral
