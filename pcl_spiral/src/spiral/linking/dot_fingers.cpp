// SPDX-License-Identifier: BSD-3-Clause
#include "dot_fingers.h"

#include "spiral/path/moves_cross.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double farthest_dot = 1.7; // distance of its middle from the loop that reaches out
constexpr double finger_gap = 0.56;  // cut out of that loop
constexpr double finger_cap = 0.25;
constexpr double finger_reach = 3.0, finger_grain = 0.1; // part of the loop on either side that a finger must not cross
constexpr double along_reach = 1.0;                      // to either side of the nearest place, to find a better one

/** Mean of the places along \p loop. */
Eigen::Vector3d
middleOf(const ScallopLoop& loop)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < loop.points.size(); ++i)
    sum += (loop.arcs[i + 1] - loop.arcs[i]) * 0.5 * (loop.points[i] + loop.points[(i + 1) % loop.points.size()]);
  return sum / loop.length();
}

class DotReacher {
public:
  DotReacher(const LoopFinder& finder, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path)
  : finder_(finder), joined_(joined), loops_(loops), path_(path)
  {}

  void run()
  {
    for (std::size_t i = 0; i < loops_.size(); ++i)
      if (!joined_[i] && loops_.loop(i).length() <= longest_dot)
        reachDot(i);
  }

private:
  /** A loop near the dot reaches out to its middle and back. */
  void reachDot(std::size_t dot)
  {
    const ScallopLoop& small = loops_.loop(dot);
    const Eigen::Vector3d centre = middleOf(small);
    const StepOverMetric metric = small.metric.front();
    LoopPlace best;
    double least = 1e30;
    for (int step = -1; step <= 1; ++step) {
      const LoopPlace near = finder_.nearest(small.level + step, centre, metric, farthest_dot, dot);
      if (near.loop == LoopPlace::none || loops_.loop(near.loop).length() <= longest_dot)
        continue;
      // The nearest place, or one a little to either side if it is taken or bent.
      for (double x = -along_reach; x <= along_reach + 0.05; x += 0.1) {
        const ScallopLoop& loop = loops_.loop(near.loop);
        const double u = near.u + x, d = metric.length(loop.at(u) - centre);
        const double chord = metric.length(loop.at(u + finger_gap) - loop.at(u - finger_gap)) / (2.0 * finger_gap);
        const double score = d + 3.0 * (1.0 - chord);
        if (d < farthest_dot && score < least && loops_.isFree(near.loop, u, finger_gap) && !crosses(loop, u, centre)) {
          least = score;
          best = {near.loop, u, d};
        }
      }
    }
    if (best.loop != LoopPlace::none)
      finger(dot, best, centre);
  }
  /** Whether a finger from \p u to \p centre crosses its loop, as at a sharp bend. */
  static bool crosses(const ScallopLoop& loop, double u, const Eigen::Vector3d& centre)
  {
    const double reach = std::min(finger_reach, 0.5 * loop.length());
    const Eigen::Vector3d from = loop.at(u - 0.5 * finger_gap), to = loop.at(u + 0.5 * finger_gap), way = centre - loop.at(u);
    for (double x = 0.5 * finger_gap; x < reach; x += finger_grain)
      for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d a = loop.at(u + side * x), b = loop.at(u + side * (x + finger_grain));
        if (movesCross(from, from + way, a, b) || movesCross(to, to + way, a, b))
          return true;
      }
    return false;
  }
  void finger(std::size_t dot, const LoopPlace& place, const Eigen::Vector3d& centre)
  {
    const ScallopLoop& loop = loops_.loop(place.loop);
    const Eigen::Vector3d from = loop.at(place.u - 0.5 * finger_gap), middle = loop.at(place.u), to = loop.at(place.u + 0.5 * finger_gap);
    const StepOverMetric metric = loops_.loop(dot).metric.front(), at = loop.metricAt(place.u);
    const Eigen::Vector3d tip = (centre - middle) / std::max(metric.length(centre - middle), 1e-12) * finger_cap;
    const std::size_t cut = loops_.addCut({place.loop, place.u - 0.5 * finger_gap, finger_gap});
    PathPiece piece;
    for (int k = 1; k <= 15; ++k)
      piece.add(from + (centre - middle) * (k / 16.0), between(at, metric, k / 16.0));
    for (int k = 0; k <= 14; ++k) {
      const double t = pi * k / 14.0;
      piece.add(centre + std::cos(t) * (from - middle) + std::sin(t) * tip, metric);
    }
    for (int k = 15; k >= 1; --k)
      piece.add(to + (centre - middle) * (k / 16.0), between(at, metric, k / 16.0));
    loops_.connect({cut, false}, {cut, true}, std::move(piece));
    joined_[dot] = travelled_as_dot;
    path_.joints.push_back({dot, place.loop, LoopJointKind::Finger, centre, middle});
    ++path_.dots;
  }

  const LoopFinder& finder_;
  std::vector<std::uint8_t>& joined_;
  CutLoops& loops_;
  LinkedPath& path_;
};

} // namespace

void
reachDots(const LoopFinder& finder, std::vector<std::uint8_t>& joined, CutLoops& loops, LinkedPath& path)
{
  DotReacher(finder, joined, loops, path).run();
}

} // namespace pcl_spiral
