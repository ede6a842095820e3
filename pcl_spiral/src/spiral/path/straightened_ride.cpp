// SPDX-License-Identifier: BSD-3-Clause
#include "straightened_ride.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace pcl_spiral {
namespace {

constexpr double look_step = 0.05;    // of the radius: between places that are looked at on a straight way
constexpr double longest_foot = 0.25; // of the radius: the move of a foot for which the axis needs a point
constexpr int cut_rounds = 3;         // of hairpins: one that is cut may leave a shorter one
constexpr double evened = 0.1;        // share of the even speed of the feet in that of the ball, so that it never stops

/** Points of a path from the first to the last, both included. */
struct Stretch {
  std::size_t first, last;
};

/** Straightens one stretch. */
class Straightening {
public:
  Straightening(const RiddenPath& path, const Stretch& stretch, const BallReach& reach, const RideTolerance& tolerance);

  /** Without the first point of the stretch, which stays. */
  RiddenPath straight() const;

private:
  const RiddenPoint& at(std::size_t i) const { return path_[stretch_.first + i]; }
  bool keepsHeight(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double height) const;
  bool isStraight(std::size_t from, std::size_t to, double aside) const;
  std::size_t farthest(std::size_t from) const;
  std::size_t nearestBall(std::size_t first, std::size_t last, std::size_t to) const;
  bool turnsBack(std::size_t before, std::size_t bend, std::size_t after) const;
  std::size_t cutHairpin(std::size_t before, std::size_t bend, std::size_t after) const;
  bool isOneMove(const RiddenPoint& from, const RiddenPoint& to) const;
  std::vector<double> sharesOfWay(std::size_t from, std::size_t to) const;
  void append(std::size_t from, std::size_t to, RiddenPath& straight) const;

  const RiddenPath& path_;
  Stretch stretch_;
  const BallReach& reach_;
  RideTolerance tolerance_;
  std::vector<double> heights_; // of the balls, for each point of the stretch
};

/** Distance of \p place from the way from \p from to \p to. */
double
distanceToWay(const Eigen::Vector3d& place, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d way = to - from, off = place - from;
  const double square = way.squaredNorm(), share = square > 0.0 ? std::clamp(off.dot(way) / square, 0.0, 1.0) : 0.0;
  return (off - share * way).norm();
}

Straightening::Straightening(const RiddenPath& path, const Stretch& stretch, const BallReach& reach, const RideTolerance& tolerance)
: path_(path), stretch_(stretch), reach_(reach), tolerance_(tolerance)
{
  for (std::size_t i = stretch.first; i <= stretch.last; ++i)
    heights_.push_back(reach.height(path[i].centre, reach.radius()));
}

/** True if the ball on the straight way is nowhere too deep, and nowhere more than the chord error above \p height. */
bool
Straightening::keepsHeight(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double height) const
{
  const double most = height + tolerance_.chord_error;
  const int pieces = std::max(2, static_cast<int>(std::ceil((to - from).norm() / (look_step * reach_.radius()))));
  for (int k = 1; k < pieces; ++k) {
    const double over = reach_.height(from + (to - from) * k / pieces, most);
    if (over >= most || over < -tolerance_.chord_error)
      return false;
  }
  return true;
}

bool
Straightening::isStraight(std::size_t from, std::size_t to, double aside) const
{
  for (std::size_t k = from + 1; k < to; ++k)
    if (distanceToWay(at(k).centre, at(from).centre, at(to).centre) > aside)
      return false;
  const auto heights = heights_.begin();
  return keepsHeight(at(from).centre, at(to).centre,
                     *std::max_element(heights + static_cast<std::ptrdiff_t>(from), heights + static_cast<std::ptrdiff_t>(to) + 1));
}

/** The farthest point to which the ball can go straight from point \p from. */
std::size_t
Straightening::farthest(std::size_t from) const
{
  const std::size_t last = stretch_.last - stretch_.first;
  std::size_t good = from + 1, bad = last + 1;
  for (std::size_t ahead = 2; good < last && bad > last; ahead *= 2) {
    const std::size_t to = std::min(from + ahead, last);
    (isStraight(from, to, tolerance_.aside) ? good : bad) = to;
  }
  while (good < last && bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (isStraight(from, middle, tolerance_.aside) ? good : bad) = middle;
  }
  return good;
}

/** True if no point is needed between two: the ball, with its contact on straight moves, stays within the chord error of its way. */
bool
Straightening::isOneMove(const RiddenPoint& from, const RiddenPoint& to) const
{
  const double radius = reach_.radius(), rise = radius - 0.5 * radius * (from.normal + to.normal).norm();
  return rise <= tolerance_.chord_error && (to.foot - from.foot).norm() <= std::min(longest_foot * radius, tolerance_.longest_step) &&
         (to.contact(radius) - from.contact(radius)).norm() <= tolerance_.longest_step;
}

/** Where the balls of the points \p from to \p to come to be on the straight way: next to their places before, but each a little ahead of
 *  the one before it. */
std::vector<double>
Straightening::sharesOfWay(std::size_t from, std::size_t to) const
{
  const Eigen::Vector3d way = at(to).centre - at(from).centre;
  const double square = way.squaredNorm();
  std::vector<double> shares, lengths(1, 0.0); // of the way of the feet
  for (std::size_t k = from; k <= to; ++k) {
    if (k > from)
      lengths.push_back(lengths.back() + (at(k).foot - at(k - 1).foot).norm());
    shares.push_back(square > 0.0 ? std::clamp((at(k).centre - at(from).centre).dot(way) / square, 0.0, 1.0) : 1.0);
  }
  std::vector<double> least = shares; // of the points from here on
  for (std::size_t k = least.size() - 1; k-- > 0;)
    least[k] = std::min(least[k], least[k + 1]);
  double most = 0.0; // of the points up to here
  for (std::size_t k = 0; k < shares.size(); ++k) {
    most = std::max(most, shares[k]);
    const double even = lengths.back() > 0.0 ? lengths[k] / lengths.back() : 1.0;
    shares[k] = (1.0 - evened) * 0.5 * (most + least[k]) + evened * even;
  }
  return shares;
}

/** Appends the points after \p from up to \p to, on the straight way between them, with as few of those between as needed. */
void
Straightening::append(std::size_t from, std::size_t to, RiddenPath& straight) const
{
  if (from == to)
    return;
  RiddenPath on;
  const std::vector<double> shares = sharesOfWay(from, to);
  for (std::size_t k = from + 1; k <= to; ++k)
    on.push_back(at(k));
  for (std::size_t k = 0; k + 1 < on.size(); ++k) {
    on[k].centre = at(from).centre + shares[k + 1] * (at(to).centre - at(from).centre);
    on[k].lifted = true;
  }
  for (std::size_t k = 0; k < on.size(); ++k)
    if (k + 1 == on.size() || !isOneMove(straight.back(), on[k + 1]))
      straight.push_back(on[k]);
}

/** The point from \p first to \p last whose ball is nearest to that of point \p to. */
std::size_t
Straightening::nearestBall(std::size_t first, std::size_t last, std::size_t to) const
{
  std::size_t nearest = first;
  for (std::size_t k = first; k <= last; ++k)
    if ((at(k).centre - at(to).centre).squaredNorm() < (at(nearest).centre - at(to).centre).squaredNorm())
      nearest = k;
  return nearest;
}

bool
Straightening::turnsBack(std::size_t before, std::size_t bend, std::size_t after) const
{
  return (at(bend).centre - at(before).centre).dot(at(after).centre - at(bend).centre) < 0.0;
}

/** Where the ways from \p before to \p bend and on to \p after turn by more than 90 degrees, the end of the hairpin is cut off: at the
 *  point of the longer way from which the ball need not turn back to reach the end of the shorter one. The bend, if none is near enough. */
std::size_t
Straightening::cutHairpin(std::size_t before, std::size_t bend, std::size_t after) const
{
  if (!turnsBack(before, bend, after))
    return bend;
  const bool comes_back = (at(bend).centre - at(before).centre).norm() > (at(after).centre - at(bend).centre).norm();
  std::size_t cut = comes_back ? nearestBall(before, bend, after) : nearestBall(bend, after, before);
  if (cut > before && cut < after && turnsBack(before, cut, after))
    comes_back ? --cut : ++cut;
  return (comes_back ? isStraight(cut, after, tolerance_.hairpin) : isStraight(before, cut, tolerance_.hairpin)) ? cut : bend;
}

RiddenPath
Straightening::straight() const
{
  std::vector<std::size_t> bends(1, 0);
  while (stretch_.first + bends.back() < stretch_.last)
    bends.push_back(farthest(bends.back()));
  for (int round = 0; round < cut_rounds; ++round)
    for (std::size_t k = 1; k + 1 < bends.size(); ++k)
      bends[k] = cutHairpin(bends[k - 1], bends[k], bends[k + 1]);
  RiddenPath straight(1, at(0));
  for (std::size_t k = 1; k < bends.size(); ++k)
    append(bends[k - 1], bends[k], straight);
  straight.erase(straight.begin());
  return straight;
}

/** Lifted points that follow each other, each stretch with the points beside it in its pass. */
std::vector<Stretch>
liftedStretches(const RiddenPath& path)
{
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!path[i].lifted)
      continue;
    const std::size_t before = i > 0 && !path[i].begins_pass ? i - 1 : i;
    while (i + 1 < path.size() && !path[i + 1].begins_pass && path[i].lifted)
      ++i;
    if (!stretches.empty() && stretches.back().last == before && before < i)
      stretches.back().last = i;
    else
      stretches.push_back({before, i});
  }
  return stretches;
}

} // namespace

RiddenPath
straightenedRide(const RiddenPath& path, const BallReach& reach, const RideTolerance& tolerance)
{
  const std::vector<Stretch> stretches = liftedStretches(path);
  std::vector<RiddenPath> straight(stretches.size());
  const auto count = static_cast<std::int64_t>(stretches.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t k = 0; k < count; ++k)
    straight[k] = Straightening(path, stretches[k], reach, tolerance).straight();
  RiddenPath joined;
  std::size_t next = 0;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    for (; next <= stretches[k].first; ++next)
      joined.push_back(path[next]);
    joined.insert(joined.end(), straight[k].begin(), straight[k].end());
    next = stretches[k].last + 1;
  }
  for (; next < path.size(); ++next)
    joined.push_back(path[next]);
  return joined;
}

} // namespace pcl_spiral
