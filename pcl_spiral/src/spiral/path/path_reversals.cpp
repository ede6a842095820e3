// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/path_reversals.h>

#include "search/pieces.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double reversal = 150.0; // degrees
constexpr double whole = 1.0;      // turns at each end of a pass
constexpr double beside = 0.02;    // turns: this near, a corner of the outline and a corner of the path are one
constexpr double as_sharp = 10.0;  // degrees: a turn may be sharper than the outline by this

/** A place where the path changes its direction, by \p angle, degrees. */
struct Bend {
  std::size_t at;
  double angle;
};

/** True if no move leads from another place of the same pass to point \p i; \p before: where the last one to do so begins. */
template <typename Place>
bool
isAtBegin(const Place& place, const std::vector<std::size_t>& passes, std::size_t i, std::size_t& before)
{
  for (before = i; before > 0 && !beginsPass(passes, before);)
    if (place(--before) != place(i))
      return false;
  return true;
}

/** The reversals of a path of \p count points, in their order; \p place(i): of point i. */
template <typename Place>
std::vector<Bend>
findBends(std::size_t count, const Place& place, const std::vector<std::size_t>& passes)
{
  const double cosine_of_reversal = std::cos(reversal * degree);
  std::vector<std::vector<Bend>> found(pieceCount(count));
  forPieces(count, [&](std::size_t piece, std::size_t begin, std::size_t end) {
    for (std::size_t i = std::max<std::size_t>(begin, 1); i < std::min(end, count - 1); ++i) {
      const Eigen::Vector3d at = place(i), out = place(i + 1) - at;
      std::size_t before = i - 1;
      if ((at - place(before)).dot(out) > 0.0 || out.isZero(0.0) || beginsPass(passes, i + 1) || isAtBegin(place, passes, i, before))
        continue;
      const Eigen::Vector3d in = at - place(before);
      const double cosine = std::clamp(in.dot(out) / (in.norm() * out.norm()), -1.0, 1.0);
      if (cosine < cosine_of_reversal)
        found[piece].push_back({i, std::acos(cosine) / degree});
    }
  });
  std::vector<Bend> bends;
  for (const std::vector<Bend>& part : found)
    bends.insert(bends.end(), part.begin(), part.end());
  return bends;
}

double
lengthOf(const Polyline& places, std::size_t begin, std::size_t end)
{
  double length = 0.0;
  for (std::size_t i = begin + 1; i < end; ++i)
    length += (places[i] - places[i - 1]).norm();
  return length;
}

/** The turn along the rim of \p pass: the longer one of its first and its last. */
PassRange
rimTurn(const TurnedPath& path, const PassRange& pass)
{
  const auto near = [&](std::size_t i, std::size_t end) { return std::abs(path.turns[i] - path.turns[end]) <= whole; };
  std::size_t first = pass.begin, last = pass.end;
  while (first < pass.end && near(first, pass.begin))
    ++first;
  while (last > pass.begin && near(last - 1, pass.end - 1))
    --last;
  const bool at_end = lengthOf(path.places, last, pass.end) >= lengthOf(path.places, pass.begin, first);
  return at_end ? PassRange{last, pass.end} : PassRange{pass.begin, first};
}

/** Direction of travel along \p rim, one turn, at the share \p at of it; zero if it has no move there. */
Eigen::Vector3d
directionAt(const TurnedPath& path, const PassRange& rim, double at)
{
  const double from = path.turns[rim.begin], share = at - std::floor(at);
  for (std::size_t i = rim.begin + 1; i < rim.end; ++i)
    if (std::abs(path.turns[i] - from) > share && (path.places[i] - path.places[i - 1]).norm() > 0.0)
      return (path.places[i] - path.places[i - 1]).normalized();
  return Eigen::Vector3d::Zero();
}

/** How much the outline turns, in degrees, near the place where it meets the radial line of \p turn; \p rim is the turn along it. */
double
bendOfOutline(const TurnedPath& path, const PassRange& rim, double turn)
{
  if (rim.begin == rim.end)
    return 0.0;
  const double from = path.turns[rim.begin], at = path.turns[rim.end - 1] < from ? from - turn : turn - from;
  const Eigen::Vector3d in = directionAt(path, rim, at - beside), out = directionAt(path, rim, at + beside);
  return in.isZero() || out.isZero() ? 0.0 : std::acos(std::clamp(in.dot(out), -1.0, 1.0)) / degree;
}

} // namespace

std::vector<std::uint8_t>
betweenEnds(const TurnedPath& path)
{
  std::vector<std::uint8_t> between(path.places.size(), 0);
  for (const PassRange& pass : passRanges(path.passes, path.places.size())) {
    if (pass.begin >= pass.end)
      continue;
    const double first = path.turns[pass.begin], last = path.turns[pass.end - 1];
    const auto end = static_cast<std::int64_t>(pass.end);
#pragma omp parallel for schedule(static) if (pass.end - pass.begin > piece_size)
    for (auto i = static_cast<std::int64_t>(pass.begin); i < end; ++i)
      between[i] = std::abs(path.turns[i] - first) > whole && std::abs(path.turns[i] - last) > whole;
  }
  return between;
}

PathReversals
findReversals(const TurnedPath& path, const std::vector<std::uint8_t>& counted)
{
  PathReversals found;
  double sharpest = 0.0, sharpest_corner = 0.0;
  const auto place = [&path](std::size_t i) { return path.places[i]; };
  const std::vector<Bend> bends = findBends(path.places.size(), place, path.passes);
  if (bends.empty())
    return found;
  for (const PassRange& pass : passRanges(path.passes, path.places.size())) {
    if (pass.begin >= pass.end)
      continue;
    const PassRange rim = rimTurn(path, pass);
    for (const Bend& bend : bends) {
      if (bend.at < pass.begin || bend.at >= pass.end || !counted[bend.at])
        continue;
      const bool at_corner = bend.angle < bendOfOutline(path, rim, path.turns[bend.at]) + as_sharp;
      ++found.count;
      found.at_corners += at_corner;
      double& most = at_corner ? sharpest_corner : sharpest;
      const bool named = at_corner ? sharpest == 0.0 && bend.angle > most : bend.angle > most;
      most = std::max(most, bend.angle);
      if (named) {
        found.angle = bend.angle;
        found.turn = path.turns[bend.at];
        found.place = path.places[bend.at];
      }
    }
  }
  return found;
}

PathReversals
curveReversals(const std::vector<SpiralPoint>& curve)
{
  std::vector<std::size_t> passes;
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (curve[i].begins_pass)
      passes.push_back(i);
  const auto place = [&curve](std::size_t i) { return curve[i].position; };
  if (findBends(curve.size(), place, passes).empty())
    return PathReversals();
  Polyline places;
  std::vector<float> turns;
  for (const SpiralPoint& point : curve) {
    places.push_back(point.position);
    turns.push_back(static_cast<float>(point.turn));
  }
  const TurnedPath path{places, turns, passes};
  return findReversals(path, betweenEnds(path));
}

PathReversals
ballReversals(const SpiralPath& path, double tool_radius)
{
  PathReversals found;
  const auto centre = [&](std::size_t i) { return Eigen::Vector3d(path.contacts[i] + tool_radius * path.normals[i]); };
  const std::vector<Bend> of_ball = findBends(path.contacts.size(), centre, path.passes);
  if (of_ball.empty())
    return found;
  const Polyline& feet = path.onSurface();
  const auto foot = [&feet](std::size_t i) { return feet[i]; };
  const std::vector<Bend> of_feet = findBends(feet.size(), foot, path.passes);
  for (const Bend& bend : of_ball) {
    const auto beside = std::lower_bound(of_feet.begin(), of_feet.end(), bend.at, [](const Bend& b, std::size_t at) { return b.at < at; });
    if (beside != of_feet.end() && beside->at == bend.at)
      continue;
    ++found.count;
    found.lifted += !path.lifts.empty() && path.lifts[bend.at] > 0.0f;
    if (bend.angle > found.angle) {
      found.angle = bend.angle;
      found.turn = path.turns[bend.at];
      found.place = path.contacts[bend.at];
    }
  }
  return found;
}

Diagnostic
reversalText(const PathReversals& reversals)
{
  return Diagnostic("the path turns back by ", reversals.angle, " {degrees} from one move to the next at ", Place(reversals.place),
                    " in turn ", reversals.turn, ", and by more than ", reversal, " {degrees} at ", reversals.count, " places in all");
}

} // namespace pcl_spiral
