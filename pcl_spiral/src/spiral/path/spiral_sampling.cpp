// SPDX-License-Identifier: BSD-3-Clause
#include "core/angle_between.h"
#include "core/parallel_resize.h"
#include <pcl_spiral/spiral/impl/spiral_curve.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double spiral_step_reserve = 0.98; // projection stretches steps a little

struct HermiteSegment {
  Eigen::Vector3d a, b, ta, tb; ///< ends, and derivatives over chord length
  double chord;

  Eigen::Vector3d at(double t) const
  {
    const double t2 = t * t, t3 = t2 * t;
    return (2 * t3 - 3 * t2 + 1) * a + (3 * t2 - 2 * t3) * b + chord * ((t3 - 2 * t2 + t) * ta + (t3 - t2) * tb);
  }
};

/** A run of knots between corners. */
struct StepStretch {
  std::size_t begin, end;
  double needed; ///< number of steps
};

/** The next larger count of a series with steps of five percent. */
double
wholeSteps(double needed)
{
  double rung = 1.0;
  while (rung < needed)
    rung = std::max(rung + 1.0, std::ceil(1.05 * rung));
  return rung;
}

/** Turns with the same group number get the same number of steps: a group spans up to six percent of the turns below. */
int
turnGroup(double turn)
{
  constexpr double single = 16.0, growth = 1.06;
  const double whole = std::floor(std::max(0.0, turn));
  return static_cast<int>(whole < single ? whole : single + std::floor(std::log(whole / single) / std::log(growth)));
}

/** Knots from one corner or anchor to the next. */
template <typename Knot>
std::vector<StepStretch>
stretchesOf(const std::vector<Knot>& knots, const std::vector<double>& steps)
{
  std::vector<StepStretch> stretches;
  for (std::size_t begin = 0; begin < steps.size();) {
    StepStretch stretch{begin, begin + 1, steps[begin]};
    while (stretch.end < steps.size() && !knots[stretch.end].corner && !knots[stretch.end].anchor)
      stretch.needed += steps[stretch.end++];
    stretches.push_back(stretch);
    begin = stretch.end;
  }
  return stretches;
}

/** Number of steps of each stretch. Rounding of the input almost never changes counts that come from few decisions and
 *  coarse steps, so similar stretches of neighbouring turns take the same. */
template <typename Knot>
std::vector<double>
stepCounts(const std::vector<Knot>& knots, const std::vector<StepStretch>& stretches)
{
  std::map<std::pair<int, int>, double> counts;
  std::vector<std::pair<int, int>> alike; // group of turns, place in the turn
  double last_turn = -1.0;
  for (const StepStretch& stretch : stretches) {
    const int group = turnGroup(knots[stretch.begin].turn);
    const bool same_turn = !alike.empty() && std::floor(knots[stretch.begin].turn) == last_turn;
    alike.emplace_back(group, same_turn ? alike.back().second + 1 : 0);
    last_turn = std::floor(knots[stretch.begin].turn);
    double& count = counts[alike.back()];
    count = std::max(count, wholeSteps(stretch.needed));
  }
  std::vector<double> result;
  result.reserve(alike.size());
  for (const std::pair<int, int>& kind : alike)
    result.push_back(counts.at(kind));
  return result;
}

} // namespace

Eigen::Vector3d
SpiralCurve::tangent(const std::vector<Knot>& knots, std::size_t k, bool after_corner)
{
  const auto n = static_cast<std::int64_t>(knots.size());
  // Parabolas over chord length: through both neighbours, or, at a corner, through the two on the given side.
  const auto oneSided = [&](std::int64_t p, std::int64_t direction) -> Eigen::Vector3d {
    const std::int64_t q = p + direction, r = p + 2 * direction;
    const Eigen::Vector3d first = knots[q].position - knots[p].position;
    const double h1 = first.norm();
    Eigen::Vector3d slope = first / h1;
    if (r >= 0 && r < n && !knots[q].corner) {
      const Eigen::Vector3d second = knots[r].position - knots[q].position;
      const double h2 = second.norm();
      slope += (slope - second / h2) * (h1 / (h1 + h2));
    }
    return static_cast<double>(direction) * slope;
  };
  const auto i = static_cast<std::int64_t>(k);
  const bool first = i == 0, last = i + 1 == n;
  if (first || last || knots[k].corner) {
    const bool ahead = first || (!last && after_corner);
    return oneSided(i, ahead ? 1 : -1);
  }
  const Eigen::Vector3d back = knots[k].position - knots[k - 1].position;
  const Eigen::Vector3d ahead = knots[k + 1].position - knots[k].position;
  const double h0 = back.norm(), h1 = ahead.norm();
  return (back * (h1 / h0) + ahead * (h0 / h1)) / (h0 + h1);
}

std::vector<Eigen::Vector3d>
SpiralCurve::tangents(const std::vector<Knot>& knots)
{
  std::vector<Eigen::Vector3d> result;
  resizeInParallel(result, knots.size());
  const auto n = static_cast<std::int64_t>(knots.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t k = 0; k < n; ++k)
    result[k] = tangent(knots, k, true);
  return result;
}

Eigen::Vector3d
SpiralCurve::arriving(const std::vector<Knot>& knots, const std::vector<Eigen::Vector3d>& leaving, std::size_t k)
{
  return knots[k].corner ? tangent(knots, k, false) : leaving[k];
}

std::vector<double>
SpiralCurve::stepsNeeded(const std::vector<Knot>& knots, const std::vector<Eigen::Vector3d>& leaving) const
{
  const std::size_t segments = knots.size() - 1;
  std::vector<double> steps(segments);
#pragma omp parallel for schedule(static)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(segments); ++k) {
    const double chord = (knots[k + 1].position - knots[k].position).norm();
    const double turned = angleBetween(leaving[k], arriving(knots, leaving, k + 1));
    const double length = chord * (1.0 + turned * turned / 24.0);
    const double bend = turned > 0.0 ? 2.0 * std::sqrt(2.0 * settings_.chord_error * length / turned) : max_step_;
    const double step = std::min({knots[k].step, knots[k + 1].step, bend, max_step_});
    steps[k] = length / (spiral_step_reserve * step);
  }
  return steps;
}

std::vector<SpiralPoint>
SpiralCurve::sample() const
{
  const std::vector<Knot> knots = this->knots();
  const std::vector<Eigen::Vector3d> leaving = tangents(knots);
  const std::vector<double> steps = stepsNeeded(knots, leaving);
  const std::vector<StepStretch> stretches = stretchesOf(knots, steps);
  const std::vector<double> counts = stepCounts(knots, stretches);
  // Points of a stretch, by their place in it: the last one lies at least half a step before the end.
  const auto forEachPoint = [&](std::size_t i, auto visit) {
    const auto [begin, end, needed] = stretches[i];
    const double each = needed / counts[i];
    double before = 0.0, next = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
      for (; next < before + steps[k] && next < needed - 0.5 * each; next += each)
        visit(k, (next - before) / steps[k]);
      before += steps[k];
    }
  };
  const auto stretch_count = static_cast<std::int64_t>(stretches.size());
  std::vector<std::size_t> starts(stretches.size() + 1, 0);
#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t i = 0; i < stretch_count; ++i)
    forEachPoint(i, [&](std::size_t, double) { ++starts[i + 1]; });
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  std::vector<SpiralPoint> points;
  resizeInParallel(points, starts.back() + 1);
#pragma omp parallel for schedule(dynamic, 16)
  for (std::int64_t i = 0; i < stretch_count; ++i) {
    std::size_t place = starts[i];
    forEachPoint(i, [&](std::size_t k, double t) {
      const HermiteSegment segment{knots[k].position, knots[k + 1].position, leaving[k], arriving(knots, leaving, k + 1),
                                   (knots[k + 1].position - knots[k].position).norm()};
      points[place++] = {segment.at(t), knots[k].turn + t * (knots[k + 1].turn - knots[k].turn)};
    });
  }
  points.back() = {knots.back().position, knots.back().turn};
  if (settings_.direction == SpiralDirection::Inward) {
    const double all_turns = points.back().turn;
    std::reverse(points.begin(), points.end());
    for (SpiralPoint& p : points)
      p.turn = all_turns - p.turn;
  }
  return points;
}

} // namespace pcl_spiral
