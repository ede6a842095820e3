// SPDX-License-Identifier: BSD-3-Clause
#include "finger_axes.h"

#include "axis_line.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double covered_by_axis = finger_trim + 0.02;
constexpr double neck_step = 0.2;       // distance between the starts of axes in necks
constexpr double worth_an_axis = 0.525; // nearer places are reached by moving the path (coverPath)
constexpr double same_ridge = 1.6;      // two axes that start this near may be one axis over a saddle
constexpr std::size_t most_axes = 40;   // in one uncovered part

void
strikeOut(const StepOverMesh& mesh, const std::vector<std::uint32_t>& nodes, const FingerAxis& axis, double within,
          std::vector<std::uint8_t>& open)
{
  SegmentSet line;
  line.add(axis.points, false);
  line.build();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (open[i] && line.nearest(mesh.positions[nodes[i]], mesh.metric[nodes[i]], within).segment != NearestSegment::none)
      open[i] = 0;
}

/** Fingers of one connected uncovered part. */
class FingerMaker {
public:
  FingerMaker(const StepOverDistance& field, const RidgeClimb& climb, const LevelGap& gap, std::vector<FingerAxis>& axes)
  : field_(field), climb_(climb), gap_(gap), axes_(axes)
  {}

  /** Add axes until all of \p nodes are within \p covered of one. \p is_neck: the axes lie within the next loop, so none is
   *  trimmed. */
  void run(const std::vector<std::uint32_t>& nodes, double covered, bool is_neck)
  {
    std::vector<std::uint8_t> open(nodes.size(), 1);
    for (std::size_t round = 0; round < most_axes; ++round) {
      std::size_t lowest = nodes.size();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (open[i] && (lowest == nodes.size() || field_.distance[nodes[i]] < field_.distance[nodes[lowest]]))
          lowest = i;
      if (lowest == nodes.size())
        return;
      strikeOut(field_.mesh, nodes, is_neck ? addNeck(nodes[lowest]) : addFinger(nodes[lowest]), covered, open);
      open[lowest] = 0;
    }
  }

private:
  struct End {
    std::size_t loop; ///< the loop it leads into
    std::uint32_t start;
    FingerAxis way;   ///< untrimmed
    std::size_t axis; ///< in axes_
  };

  bool isWide(std::uint32_t v) const { return field_.distance[v] >= gap_.level + 1.0 + finger_radius; }
  /** From \p start, within the next loop, up the ridge until the loop is as wide as a finger. */
  FingerAxis addNeck(std::uint32_t start)
  {
    std::vector<std::uint32_t> way{start};
    while (!isWide(way.back()) && climb_.up(way.back()) != RidgeClimb::none)
      way.push_back(climb_.up(way.back()));
    axes_.push_back(axisOver(field_.mesh, way, 6));
    return axes_.back();
  }
  /** From \p start up the ridge until it is inside the next loop and the loop is as wide as a finger. */
  FingerAxis addFinger(std::uint32_t start)
  {
    std::vector<std::uint32_t> way{start};
    std::size_t loop = NearestSegment::none;
    double covered = 0.0;
    for (std::uint32_t v = start; climb_.up(v) != RidgeClimb::none; v = way.back()) {
      const std::uint32_t next = climb_.up(v);
      covered += edgeLength(field_.mesh, v, next);
      way.push_back(next);
      if (!gap_.is_above(next))
        continue;
      if (loop == NearestSegment::none)
        loop = gap_.loop_near(next);
      if (covered > finger_trim + 0.05 && isWide(next))
        break;
    }
    const FingerAxis whole = axisOver(field_.mesh, way, 6);
    const double length = arcsOf(whole).back();
    for (const End& end : ends_)
      if (loop != NearestSegment::none && end.loop != NearestSegment::none && end.loop != loop &&
          field_.mesh.metric[start].length(field_.mesh.positions[start] - field_.mesh.positions[end.start]) < same_ridge) {
        FingerAxis over = end.way; // a ridge over a saddle between two loops: one axis from one into the other
        std::reverse(over.points.begin(), over.points.end());
        std::reverse(over.metric.begin(), over.metric.end());
        over.points.insert(over.points.end(), whole.points.begin(), whole.points.end());
        over.metric.insert(over.metric.end(), whole.metric.begin(), whole.metric.end());
        axes_[end.axis] = std::move(over);
        return whole;
      }
    const FingerAxis axis = partOf(whole, std::min(finger_trim, length - 1e-9), length);
    ends_.push_back({loop, start, whole, axes_.size()});
    axes_.push_back(axis);
    return axis;
  }

  const StepOverDistance& field_;
  const RidgeClimb& climb_;
  const LevelGap& gap_;
  std::vector<FingerAxis>& axes_;
  std::vector<End> ends_;
};

} // namespace

std::vector<std::vector<std::uint32_t>>
connectedGroups(const Triangulation& triangles, const std::vector<std::uint32_t>& nodes, std::vector<std::uint32_t>& scratch)
{
  constexpr std::uint32_t waiting = 1, first_group = 2;
  for (const std::uint32_t v : nodes)
    scratch[v] = waiting;
  std::uint32_t count = 0;
  std::vector<std::uint32_t> group;
  for (const std::uint32_t seed : nodes) {
    if (scratch[seed] != waiting)
      continue;
    group.assign(1, seed);
    scratch[seed] = first_group + count;
    for (std::size_t i = 0; i < group.size(); ++i)
      forNeighbours(triangles, group[i], [&](std::uint32_t w) {
        if (scratch[w] == waiting) {
          scratch[w] = first_group + count;
          group.push_back(w);
        }
      });
    ++count;
  }
  std::vector<std::vector<std::uint32_t>> groups(count);
  for (const std::uint32_t v : nodes) {
    groups[scratch[v] - first_group].push_back(v);
    scratch[v] = 0;
  }
  return groups;
}

void
findFingers(const StepOverDistance& field, const RidgeClimb& climb, const LevelGap& gap, std::vector<std::uint32_t>& scratch,
            std::vector<FingerAxis>& axes)
{
  std::vector<std::uint32_t> open;
  for (std::size_t i = 0; i < gap.nodes.size(); ++i)
    if (gap.distances[i] > covered_within)
      open.push_back(gap.nodes[i]);
  const auto isWorth = [&gap](std::uint32_t v) {
    const auto at = std::lower_bound(gap.nodes.begin(), gap.nodes.end(), v);
    return gap.distances[at - gap.nodes.begin()] > worth_an_axis;
  };
  for (const std::vector<std::uint32_t>& group : connectedGroups(field.mesh.triangles, open, scratch))
    if (std::any_of(group.begin(), group.end(), isWorth) && std::any_of(group.begin(), group.end(), gap.is_ridge))
      FingerMaker(field, climb, gap, axes).run(group, covered_by_axis, false);
  for (const std::vector<std::uint32_t>& group : connectedGroups(field.mesh.triangles, gap.necks, scratch))
    FingerMaker(field, climb, gap, axes).run(group, neck_step, true);
}

} // namespace pcl_spiral
