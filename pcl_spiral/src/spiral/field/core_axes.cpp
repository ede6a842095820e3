// SPDX-License-Identifier: BSD-3-Clause
#include "axis_line.h"
#include "finger_axes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_branches = 30;
constexpr double infinite = std::numeric_limits<double>::infinity();

/** The middle lines of one core. */
class CoreTree {
public:
  CoreTree(const StepOverDistance& field, const std::vector<std::uint32_t>& nodes, const std::vector<double>& distances,
           std::vector<std::uint32_t>& index)
  : field_(field), nodes_(nodes), distances_(distances), index_(index), open_(nodes.size(), 0)
  {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      index_[nodes[i]] = static_cast<std::uint32_t>(i) + 1;
      open_[i] = distances[i] > covered_within;
    }
  }
  ~CoreTree()
  {
    for (const std::uint32_t v : nodes_)
      index_[v] = 0;
  }
  CoreTree(const CoreTree&) = delete;
  CoreTree& operator=(const CoreTree&) = delete;

  void run(std::vector<FingerAxis>& axes)
  {
    const auto first = std::find(open_.begin(), open_.end(), 1);
    if (first == open_.end())
      return;
    walk({static_cast<std::size_t>(first - open_.begin())});
    const std::size_t a = farthestOpen();
    walk({a});
    const std::size_t b = farthestOpen();
    const FingerAxis trunk = axisOver(field_.mesh, wayTo(b), 20);
    const double length = arcsOf(trunk).back();
    add(partOf(trunk, finger_trim, length - finger_trim), axes);
    for (std::size_t i = 0; i < most_branches; ++i)
      if (!addBranch(axes))
        return;
  }

private:
  bool addBranch(std::vector<FingerAxis>& axes)
  {
    if (std::find(open_.begin(), open_.end(), 1) == open_.end())
      return false;
    walk(nodesAtAxes());
    const std::size_t b = farthestOpen();
    if (b == nodes_.size())
      return false;
    const FingerAxis branch = axisOver(field_.mesh, wayTo(b), 10);
    open_[b] = 0;
    const double length = arcsOf(branch).back();
    if (length > finger_trim)
      add(partOf(branch, 0.0, length - finger_trim), axes);
    return true;
  }
  void add(const FingerAxis& axis, std::vector<FingerAxis>& axes)
  {
    axes.push_back(axis);
    lines_.push_back(axis);
    SegmentSet line;
    line.add(axis.points, false);
    line.build();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (open_[i] &&
          line.nearest(field_.mesh.positions[nodes_[i]], field_.mesh.metric[nodes_[i]], finger_trim + 0.02).segment != NearestSegment::none)
        open_[i] = 0;
  }
  /** The node nearest to each point of the axes found so far. */
  std::vector<std::size_t> nodesAtAxes() const
  {
    std::vector<std::size_t> found;
    for (const FingerAxis& line : lines_)
      for (const Eigen::Vector3d& p : line.points) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < nodes_.size(); ++i)
          if ((field_.mesh.positions[nodes_[i]] - p).squaredNorm() < (field_.mesh.positions[nodes_[best]] - p).squaredNorm())
            best = i;
        found.push_back(best);
      }
    return found;
  }
  /** Shortest ways from \p sources. An edge costs length (0.6 / E)^4, so the ways stay far from the loops. */
  void walk(const std::vector<std::size_t>& sources)
  {
    using Entry = std::pair<double, std::size_t>;
    cost_.assign(nodes_.size(), infinite);
    from_.assign(nodes_.size(), nodes_.size());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    for (const std::size_t s : sources) {
      cost_[s] = 0.0;
      front.push({0.0, s});
    }
    while (!front.empty()) {
      const double d = front.top().first; // clang 14 has no captures of structured bindings
      const std::size_t i = front.top().second;
      front.pop();
      if (d > cost_[i])
        continue;
      forNeighbours(field_.mesh.triangles, nodes_[i], [&](std::uint32_t w) {
        if (index_[w] == 0)
          return;
        const std::size_t j = index_[w] - 1;
        const double ratio = 0.6 / std::max(0.2, std::min(distances_[i], distances_[j]));
        const double there = d + edgeLength(field_.mesh, nodes_[i], w) * ratio * ratio * ratio * ratio;
        if (there < cost_[j]) {
          cost_[j] = there;
          from_[j] = i;
          front.push({there, j});
        }
      });
    }
  }
  std::size_t farthestOpen() const
  {
    std::size_t best = nodes_.size();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (open_[i] && std::isfinite(cost_[i]) && (best == nodes_.size() || cost_[i] > cost_[best]))
        best = i;
    return best;
  }
  std::vector<std::uint32_t> wayTo(std::size_t b) const
  {
    std::vector<std::uint32_t> way;
    for (; b < nodes_.size(); b = from_[b])
      way.push_back(nodes_[b]);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const StepOverDistance& field_;
  const std::vector<std::uint32_t>& nodes_;
  const std::vector<double>& distances_;
  std::vector<std::uint32_t>& index_; ///< of a node among nodes_, plus one
  std::vector<std::uint8_t> open_;
  std::vector<FingerAxis> lines_;
  std::vector<double> cost_;
  std::vector<std::size_t> from_;
};

} // namespace

void
findCoreAxes(const StepOverDistance& field, const std::vector<std::uint32_t>& nodes, const std::vector<double>& distances,
             std::vector<std::uint32_t>& scratch, std::vector<FingerAxis>& axes)
{
  CoreTree(field, nodes, distances, scratch).run(axes);
}

} // namespace pcl_spiral
