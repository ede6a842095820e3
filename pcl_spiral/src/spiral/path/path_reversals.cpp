// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/path_reversals.h>

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double reversal = 150.0; // degrees
constexpr double whole = 1.0;      // turns at each end of a pass

} // namespace

std::vector<std::uint8_t>
betweenEnds(const TurnedPath& path)
{
  std::vector<std::uint8_t> between(path.places.size(), 0);
  for (const PassRange& pass : passRanges(path.passes, path.places.size())) {
    if (pass.begin >= pass.end)
      continue;
    const double first = path.turns[pass.begin], last = path.turns[pass.end - 1];
    for (std::size_t i = pass.begin; i < pass.end; ++i)
      between[i] = std::abs(path.turns[i] - first) > whole && std::abs(path.turns[i] - last) > whole;
  }
  return between;
}

PathReversals
findReversals(const TurnedPath& path, const std::vector<std::uint8_t>& counted)
{
  PathReversals found;
  const double least = std::cos(reversal * pi / 180.0);
  double sharpest = least;
  std::size_t before = 0; // the last point at another place
  for (std::size_t i = 1; i + 1 < path.places.size(); ++i) {
    if (beginsPass(path.passes, i))
      before = i;
    const Eigen::Vector3d in = path.places[i] - path.places[before], out = path.places[i + 1] - path.places[i];
    if (!(out.norm() > 0.0)) // the next move begins at the same place
      continue;
    before = i;
    if (!(in.norm() > 0.0) || beginsPass(path.passes, i + 1) || !counted[i])
      continue;
    const double cosine = in.dot(out) / (in.norm() * out.norm());
    if (cosine >= least)
      continue;
    ++found.count;
    if (cosine < sharpest) {
      sharpest = cosine;
      found.place = path.places[i];
      found.turn = path.turns[i];
      found.angle = std::acos(std::max(-1.0, cosine)) * 180.0 / pi;
    }
  }
  return found;
}

PathReversals
curveReversals(const std::vector<SpiralPoint>& curve)
{
  Polyline places;
  std::vector<float> turns;
  std::vector<std::size_t> passes;
  places.reserve(curve.size());
  turns.reserve(curve.size());
  for (std::size_t i = 0; i < curve.size(); ++i) {
    places.push_back(curve[i].position);
    turns.push_back(static_cast<float>(curve[i].turn));
    if (i > 0 && curve[i].begins_pass)
      passes.push_back(i);
  }
  const TurnedPath path{places, turns, passes};
  return findReversals(path, betweenEnds(path));
}

std::string
reversalText(const PathReversals& reversals)
{
  return textOf("the path turns back by ", reversals.angle, " degrees from one move to the next at ", placeText(reversals.place),
                " in turn ", reversals.turn, ", and by more than ", reversal, " degrees at ", reversals.count, " places in all");
}

} // namespace pcl_spiral
