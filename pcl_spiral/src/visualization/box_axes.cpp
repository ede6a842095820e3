// SPDX-License-Identifier: BSD-3-Clause
#include "box_axes.h"

#include "common/formatted_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double shortest_axis = 40.0; ///< pixels; an edge seen end on gets no numbers
constexpr double flat_room = 85.0;     ///< pixels along a flat edge for one number
constexpr double steep_room = 55.0;
constexpr double text_gap = 5.0, name_gap = 12.0;
constexpr double outline_tolerance = 3.0; ///< pixels that an edge may be inside the outline

/** An edge of the box, and the axis along it. */
struct Candidate {
  BoxAxis axis;
  std::array<int, 2> ends; ///< corners of the box: a bit is set if the coordinate is high
  bool steep;
};

/** Text whose nearest corner is \p distance from the axis. */
AxisText
textBeside(const std::string& words, int size, const Eigen::Vector2d& at, const Eigen::Vector2d& outward, double distance)
{
  const Eigen::Vector2d half(0.285 * size * static_cast<double>(words.size()), 0.62 * size);
  return {words, size, at + (distance + outward.cwiseAbs().dot(half)) * outward, half};
}

bool
overlap(const AxisText& a, const AxisText& b)
{
  return ((a.middle - b.middle).cwiseAbs().array() < (a.half_size + b.half_size).array()).all();
}

/** Whether two axes run along each other. */
bool
overlap(const BoxAxis& a, const BoxAxis& b)
{
  const Eigen::Vector2d along = (a.to - a.from).normalized();
  const auto off = [&](const Eigen::Vector2d& p) { return std::abs(along.x() * (p.y() - a.from.y()) - along.y() * (p.x() - a.from.x())); };
  const double length = (a.to - a.from).norm();
  const double s = along.dot(b.from - a.from), t = along.dot(b.to - a.from);
  const double shared = std::min(length, std::max(s, t)) - std::max(0.0, std::min(s, t));
  return std::max(off(b.from), off(b.to)) < 2.0 * axis_tick_length && shared > outline_tolerance;
}

void
addTicks(BoxAxis& axis, bool steep, double low, double high)
{
  const Eigen::Vector2d run = axis.to - axis.from;
  const double step = niceStep((high - low) * (steep ? steep_room : flat_room) / run.norm());
  double depth = 0.0;
  std::vector<AxisText> numbers;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0) {
    const Eigen::Vector2d at = axis.from + (k * step - low) / (high - low) * run;
    axis.ticks.push_back(at);
    numbers.push_back(textBeside(formatted("%.6g", k == 0.0 ? 0.0 : k * step), number_size, at, axis.outward, axis_tick_length + text_gap));
    depth = std::max(depth, 2.0 * axis.outward.cwiseAbs().dot(numbers.back().half_size));
  }
  axis.texts.push_back(textBeside(std::string(1, "xyz"[axis.axis]) + ", mm", name_size, axis.from + 0.5 * run, axis.outward,
                                  axis_tick_length + text_gap + depth + name_gap));
  axis.texts.insert(axis.texts.end(), numbers.begin(), numbers.end());
}

/** The edges along one axis that are on the outline. */
std::vector<Candidate>
outlineEdges(int axis, const Eigen::Vector3d& low, const Eigen::Vector3d& high, const ParallelView& view)
{
  std::array<Eigen::Vector2d, 8> corners;
  for (int c = 0; c < 8; ++c)
    corners[c] = view.project(Eigen::Vector3d((c & 1 ? high : low).x(), (c & 2 ? high : low).y(), (c & 4 ? high : low).z()));
  std::vector<Candidate> edges;
  for (int c = 0; c < 8; ++c) {
    if (c & (1 << axis))
      continue;
    const int end = c | (1 << axis);
    const Eigen::Vector2d run = corners[end] - corners[c];
    if (run.norm() < shortest_axis)
      continue;
    for (const double side : {1.0, -1.0}) {
      const Eigen::Vector2d outward = side * Eigen::Vector2d(-run.y(), run.x()).normalized();
      const bool outermost = std::all_of(corners.begin(), corners.end(),
                                         [&](const Eigen::Vector2d& p) { return outward.dot(p - corners[c]) <= outline_tolerance; });
      if (!outermost)
        continue;
      const bool steep = std::abs(run.y()) > std::abs(run.x());
      Candidate edge{{axis, corners[c], corners[end], outward, {}, {}}, {c, end}, steep};
      addTicks(edge.axis, steep, low[axis], high[axis]);
      edges.push_back(std::move(edge));
    }
  }
  return edges;
}

/** Cost of a single edge. */
double
cost(const Candidate& edge)
{
  return edge.steep ? (edge.axis.outward.x() > 0.0 ? 0.3 : 0.0) : (edge.axis.outward.y() > 0.0 ? 1.0 : 0.0);
}

/** Cost of two edges together. */
double
cost(const Candidate& a, const Candidate& b)
{
  double sum = overlap(a.axis, b.axis) ? 100.0 : 0.0;
  for (const AxisText& s : a.axis.texts)
    for (const AxisText& t : b.axis.texts)
      sum += overlap(s, t) ? 10.0 : 0.0;
  if (a.axis.outward.dot(b.axis.outward) > 0.9)
    sum += 2.0; // one axis would look like the continuation of the other
  const bool meet = a.ends[0] == b.ends[0] || a.ends[0] == b.ends[1] || a.ends[1] == b.ends[0] || a.ends[1] == b.ends[1];
  return sum + (meet ? 0.0 : 0.5);
}

/** Leaves out numbers, those of the later axis first, until no two texts overlap. */
void
dropOverlaps(std::vector<BoxAxis>& axes)
{
  std::vector<AxisText> kept;
  kept.reserve(axes.size());
  for (const BoxAxis& axis : axes)
    kept.push_back(axis.texts.front());
  for (BoxAxis& axis : axes) {
    std::vector<AxisText> texts{axis.texts.front()};
    for (std::size_t i = 1; i < axis.texts.size(); ++i)
      if (std::none_of(kept.begin(), kept.end(), [&](const AxisText& t) { return overlap(t, axis.texts[i]); })) {
        kept.push_back(axis.texts[i]);
        texts.push_back(axis.texts[i]);
      }
    axis.texts = std::move(texts);
  }
}

} // namespace

double
niceStep(double least)
{
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least)
      return factor * power;
  return 10.0 * power;
}

std::vector<BoxAxis>
layOutAxes(const Eigen::Vector3d& low, const Eigen::Vector3d& high, const ParallelView& view)
{
  std::vector<std::vector<Candidate>> edges;
  for (int axis = 0; axis < 3; ++axis)
    if (auto found = outlineEdges(axis, low, high, view); !found.empty())
      edges.push_back(std::move(found));
  std::vector<const Candidate*> choice(edges.size()), best;
  double least = std::numeric_limits<double>::max();
  const auto choose = [&](const auto& self, std::size_t level, double so_far) -> void {
    if (so_far >= least)
      return;
    if (level == edges.size()) {
      least = so_far;
      best = choice;
      return;
    }
    for (const Candidate& edge : edges[level]) {
      double sum = so_far + cost(edge);
      for (std::size_t i = 0; i < level; ++i)
        sum += cost(*choice[i], edge);
      choice[level] = &edge;
      self(self, level + 1, sum);
    }
  };
  choose(choose, 0, 0.0);
  std::vector<BoxAxis> axes;
  axes.reserve(best.size());
  for (const Candidate* edge : best)
    axes.push_back(edge->axis);
  dropOverlaps(axes);
  return axes;
}

} // namespace pcl_spiral
