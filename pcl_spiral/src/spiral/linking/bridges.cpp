// SPDX-License-Identifier: BSD-3-Clause
#include "bridges.h"

#include "dot_fingers.h"
#include "spiral/lines/plane_lines.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double turn_radius = 0.25;                            // of the corners of a bridge, step-overs
constexpr double half_gap = 0.04;                               // between its two lines
constexpr double beside_reach = 0.6;                            // two loops must run side by side this far to either side
constexpr double least_distance = 0.12, largest_distance = 1.5; // of two loops; those of a narrow core lie close to its rim
constexpr double between_share = 0.45;                          // of their distance: another loop this near to the middle lies between
constexpr double least_chord = 0.93;                            // of their length within that reach
constexpr double sample_step = 0.4, finer_step = 0.05;          // the finer step if no place was found
constexpr std::size_t most_samples = 400;                       // a loop
constexpr double crossing_reach = 3.0, crossing_grain = 0.1;    // of lines that a bridge might cross

/** Two loops side by side at a place. */
struct Beside {
  std::size_t a = 0, b = 0;
  double ua = 0.0, ub = 0.0;
  double distance = 0.0;
  double sense = 1.0; ///< of b against a: 1 or -1
  double score = 0.0; ///< the lower the better
};

class Joiner {
public:
  Joiner(const LoopFinder& finder, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path)
  : finder_(finder), joined_(joined), loops_(loops), path_(path)
  {}

  std::size_t run()
  {
    reachDots(finder_, joined_, loops_, path_);
    for (const bool strict : {true, false}) {
      std::vector<Beside> places;
      for (std::size_t i = 0; i < loops_.size(); ++i)
        if (!joined_[i])
          findPlaces(i, strict, places);
      join(places);
    }
    return static_cast<std::size_t>(std::find(joined_.begin(), joined_.end(), 0) - joined_.begin());
  }

private:
  void findPlaces(std::size_t i, bool strict, std::vector<Beside>& places) const
  {
    const ScallopLoop& loop = loops_.loop(i);
    const auto count =
        std::clamp<std::size_t>(static_cast<std::size_t>(loop.length() / (strict ? sample_step : finer_step)), 8, most_samples);
    std::vector<Beside> found(3 * count);
#pragma omp parallel for schedule(dynamic, 8) if (count > 64)
    for (std::size_t k = 0; k < count; ++k) {
      const double u = loop.length() * static_cast<double>(k) / static_cast<double>(count);
      for (int step = -1; step <= 1; ++step) {
        const LoopPlace other = finder_.nearest(loop.level + step, loop.at(u), loop.metricAt(u), largest_distance, i);
        Beside& place = found[3 * k + step + 1];
        place.score = -1.0;
        if (other.loop != LoopPlace::none && other.distance > least_distance)
          place = compare(i, u, other, strict);
      }
    }
    for (const Beside& place : found)
      if (place.score >= 0.0)
        places.push_back(place);
  }

  /** How well two loops run side by side about a place; a score below 0 if they do not. */
  Beside compare(std::size_t a, double ua, const LoopPlace& other, bool strict) const
  {
    const ScallopLoop &la = loops_.loop(a), &lb = loops_.loop(other.loop);
    Beside place{a, other.loop, ua, other.u, other.distance, 1.0, std::abs(other.distance - 1.0)};
    const auto along = [](const ScallopLoop& l, double u, double reach) { return (l.at(u + reach) - l.at(u - reach)).eval(); };
    const Eigen::Vector3d da = along(la, ua, beside_reach), db = along(lb, other.u, beside_reach);
    place.sense = da.dot(db) >= 0.0 ? 1.0 : -1.0;
    const double chord = std::min(la.metricAt(ua).length(da), lb.metricAt(other.u).length(db)) / (2.0 * beside_reach);
    const double room = strict ? 4.0 * beside_reach : 2.5 * beside_reach;
    if (chord < (strict ? least_chord : 0.75) || la.length() < room || lb.length() < room)
      place.score = -1.0;
    for (const double x : {-beside_reach, -0.5 * beside_reach, 0.5 * beside_reach, beside_reach}) {
      const double d = la.metricAt(ua + x).length(la.at(ua + x) - lb.at(other.u + place.sense * x));
      const double off = std::abs(d / other.distance - 1.0);
      if (off > (strict ? 0.3 : 0.6))
        place.score = -1.0;
      if (place.score >= 0.0)
        place.score += 0.5 * off;
    }
    if (place.score >= 0.0)
      place.score = isClear(place) ? place.score + 5.0 * (1.0 - chord) : -1.0;
    return place;
  }
  /** Whether no other loop lies between the two. */
  bool isClear(const Beside& place) const
  {
    const ScallopLoop& a = loops_.loop(place.a);
    const Eigen::Vector3d middle = 0.5 * (a.at(place.ua) + loops_.loop(place.b).at(place.ub));
    for (int step = -1; step <= 1; ++step)
      if (finder_.nearest(a.level + step, middle, a.metricAt(place.ua), between_share * place.distance).loop != LoopPlace::none)
        return false;
    return true;
  }

  /** Prim's tree: always take the best place between a joined loop and one that is not joined. */
  void join(const std::vector<Beside>& places)
  {
    std::vector<std::vector<std::size_t>> of(loops_.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      of[places[i].a].push_back(i);
      of[places[i].b].push_back(i);
    }
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    const auto push = [&](std::size_t loop) {
      for (const std::size_t i : of[loop])
        front.push({places[i].score, i});
    };
    for (std::size_t i = 0; i < loops_.size(); ++i)
      if (joined_[i])
        push(i);
    while (!front.empty()) {
      const Beside& place = places[front.top().second];
      front.pop();
      if ((joined_[place.a] != 0) == (joined_[place.b] != 0) || joined_[place.a] == travelled_as_dot ||
          joined_[place.b] == travelled_as_dot)
        continue;
      if (!loops_.isFree(place.a, place.ua, beside_reach) || !loops_.isFree(place.b, place.ub, beside_reach))
        continue;
      std::array<PathPiece, 2> turns = turnsOf(place);
      if (crosses(place, turns))
        continue;
      bridge(place, std::move(turns));
      const std::size_t next = joined_[place.a] ? place.b : place.a;
      joined_[next] = 1;
      push(next);
    }
  }

  /** The two bends of a bridge, back to back: on the side where arc lengths of a fall, and on the side where they rise. */
  std::array<PathPiece, 2> turnsOf(const Beside& place) const
  {
    const ScallopLoop &a = loops_.loop(place.a), &b = loops_.loop(place.b);
    const double radius = radiusOf(place);
    std::array<PathPiece, 2> turns;
    for (const double side : {-1.0, 1.0}) {
      PathPiece& piece = turns[side > 0.0];
      const auto add = [&](double x, double y) { // x along a from the middle, y from a to b, both in step-overs
        const double share = y / place.distance;
        const double ua = place.ua + side * x, ub = place.ub + place.sense * side * x;
        piece.add((1.0 - share) * a.at(ua) + share * b.at(ub), between(a.metricAt(ua), b.metricAt(ub), share));
      };
      constexpr int arc_points = 8;
      for (int k = 0; k <= arc_points; ++k) {
        const double t = 0.5 * pi * k / arc_points;
        add(half_gap + radius * (1.0 - std::sin(t)), radius * (1.0 - std::cos(t)));
      }
      for (int k = arc_points; k >= 0; --k) {
        const double t = 0.5 * pi * k / arc_points;
        add(half_gap + radius * (1.0 - std::sin(t)), place.distance - radius * (1.0 - std::cos(t)));
      }
    }
    return turns;
  }
  static double radiusOf(const Beside& place)
  {
    return std::min(turn_radius, 0.49 * place.distance);
  }
  static double halfCut(const Beside& place)
  {
    return half_gap + radiusOf(place) + 0.1;
  }

  /** Whether a part of \p piece lies where a bridge may cross it. */
  static bool isNear(const PathPiece& piece, const Eigen::Vector3d& place, const StepOverMetric& metric)
  {
    constexpr std::size_t every = 8; // points, about 0.1 step-overs apart
    for (std::size_t k = 0; k < piece.points.size(); k += every)
      if (metric.length(piece.points[k] - place) < crossing_reach)
        return true;
    return false;
  }

  /** Whether the bridge crosses a loop about it, an earlier bridge, or itself. */
  bool crosses(const Beside& place, const std::array<PathPiece, 2>& turns) const
  {
    const ScallopLoop &a = loops_.loop(place.a), &b = loops_.loop(place.b);
    const Eigen::Vector3d middle = 0.5 * (a.at(place.ua) + b.at(place.ub));
    PlaneLines lines(middle, a.at(place.ua + beside_reach) - a.at(place.ua - beside_reach), b.at(place.ub) - a.at(place.ua));
    addLoop(place.a, place.ua, halfCut(place), lines);
    addLoop(place.b, place.ub, halfCut(place), lines);
    for (int step = -1; step <= 1; ++step)
      if (const LoopPlace other = finder_.nearest(a.level + step, middle, a.metricAt(place.ua), largest_distance, place.a);
          other.loop != LoopPlace::none && other.loop != place.b)
        addLoop(other.loop, other.u, 0.0, lines);
    for (const PathPiece& piece : loops_.pieces())
      if (isNear(piece, middle, a.metricAt(place.ua)))
        lines.add(piece.points);
    const double half = halfCut(place);
    std::array<Polyline, 2> whole; // from cut to cut
    for (const double side : {-1.0, 1.0}) {
      Polyline& line = whole[side > 0.0];
      line.assign(1, a.at(place.ua + side * half));
      const Polyline& turn = turns[side > 0.0].points;
      line.insert(line.end(), turn.begin(), turn.end());
      line.push_back(b.at(place.ub + place.sense * side * half));
    }
    if (lines.crossedBy(whole[0]))
      return true;
    lines.add(whole[0]);
    return lines.crossedBy(whole[1]);
  }
  /** Add the near parts of a loop, without a cut of twice \p half about \p u. */
  void addLoop(std::size_t i, double u, double half, PlaneLines& lines) const
  {
    const ScallopLoop& loop = loops_.loop(i);
    const bool whole = loop.length() <= 2.0 * crossing_reach;
    const auto stretch = [&](double from, double to) {
      Polyline line;
      const auto steps = static_cast<int>(std::ceil((to - from) / crossing_grain));
      for (int k = 0; k <= steps; ++k)
        line.push_back(loop.at(u + from + (to - from) * k / steps));
      lines.add(line);
    };
    if (whole)
      stretch(half, loop.length() - half);
    else {
      stretch(half, crossing_reach);
      stretch(-crossing_reach, -half);
    }
  }

  /** Cut both loops and join their ends by two bends. */
  void bridge(const Beside& place, std::array<PathPiece, 2> turns)
  {
    const ScallopLoop &a = loops_.loop(place.a), &b = loops_.loop(place.b);
    const double half = halfCut(place);
    const std::size_t cut_a = loops_.addCut({place.a, place.ua - half, 2.0 * half});
    const std::size_t cut_b = loops_.addCut({place.b, place.ub - half, 2.0 * half});
    for (const bool rising : {false, true}) {
      // The facing end of b: its begin if b runs like a and this is the left side, else its end.
      loops_.connect({cut_a, rising}, {cut_b, rising == (place.sense > 0.0)}, std::move(turns[rising]));
    }
    addTests(place);
    const bool outward = joined_[place.a] != 0; // from a, which is linked, to b
    path_.joints.push_back({outward ? place.b : place.a, outward ? place.a : place.b, LoopJointKind::Bridge,
                            outward ? b.at(place.ub) : a.at(place.ua), outward ? a.at(place.ua) : b.at(place.ub)});
    ++path_.bridges;
  }
  void addTests(const Beside& place)
  {
    const ScallopLoop &a = loops_.loop(place.a), &b = loops_.loop(place.b);
    const double low = a.level == 0 ? 0.0 : -0.6, high = place.distance + (b.level == 0 ? 0.0 : 0.6); // nothing beyond a rim
    for (double x = -0.9; x < 0.95; x += 0.1)
      for (double y = low; y < high + 0.05; y += 0.1) {
        const double share = y / place.distance;
        const double ua = place.ua + x, ub = place.ub + place.sense * x;
        path_.links.push_back((1.0 - share) * a.at(ua) + share * b.at(ub));
        path_.link_metric.push_back(a.metricAt(ua));
      }
  }

  const LoopFinder& finder_;
  std::vector<std::uint8_t>& joined_;
  CutLoops& loops_;
  LinkedPath& path_;
};

} // namespace

std::size_t
joinLoops(const LoopFinder& finder, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path)
{
  return Joiner(finder, joined, loops, path).run();
}

} // namespace pcl_spiral
