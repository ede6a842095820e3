// SPDX-License-Identifier: BSD-3-Clause
#include "boundary_walk.h"

#include "core/angle_between.h"
#include "search/neighbour_search.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_spiral {
namespace {

constexpr int looked_at = 64;  // nearest boundary points, including visited ones
constexpr double beside = 2.0; // spacings from a closed walk: points of the same band

/** Boundary points, and which of them were passed. */
class BoundaryWalk {
public:
  BoundaryWalk(const SurfaceGraph& graph, const std::vector<std::uint32_t>& marked, const WalkOptions& options)
  : options_(options), spacing_(graph.spacing()), blocks_(positionsOf(graph, marked)), taken_(marked.size(), 0),
    search_(blocks_, looked_at, static_cast<float>(options.reach * spacing_))
  {}

  /** The free point farthest from the mean of all free points: on the outermost boundary, wherever the cloud lies. */
  std::optional<std::uint32_t> start() const
  {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    std::size_t count = 0;
    for (std::size_t i = 0; i < taken_.size(); ++i)
      if (!taken_[i]) {
        mean += blocks_.position(i);
        ++count;
      }
    mean /= static_cast<double>(std::max<std::size_t>(count, 1));
    std::optional<std::uint32_t> best;
    double farthest = -1.0;
    for (std::size_t i = 0; i < taken_.size(); ++i)
      if (const double d = (blocks_.position(i) - mean).squaredNorm(); !taken_[i] && d > farthest) {
        farthest = d;
        best = static_cast<std::uint32_t>(i);
      }
    return best;
  }

  /** Walk from \p first; true if it came back. Points of \p path are of the blocks, all taken. */
  bool walkFrom(std::uint32_t first, std::vector<std::uint32_t>& path, double& walked)
  {
    path.assign(1, first);
    walked = 0.0;
    taken_[first] = 1;
    for (;;) {
      const auto next = step(path, walked);
      if (!next)
        return false;
      walked += (blocks_.position(*next) - blocks_.position(path.back())).norm();
      if (*next == first)
        return true;
      taken_[*next] = 1;
      path.push_back(*next);
    }
  }

  /** Take the points beside a closed walk. */
  void takeBeside(const std::vector<std::uint32_t>& path)
  {
    const double radius = beside * spacing_;
    for (const std::uint32_t i : path) {
      const Neighbourhood& near = neighbours(i);
      for (int k = 0; k < near.size; ++k)
        if (near.squared_distance[k] <= radius * radius)
          taken_[near.index[k]] = 1;
    }
  }

  std::uint32_t markedIndex(std::uint32_t i) const { return blocks_.originalIndex(i); }
  Eigen::Vector3d position(std::uint32_t i) const { return blocks_.position(i); }

private:
  static std::vector<Eigen::Vector3f> positionsOf(const SurfaceGraph& graph, const std::vector<std::uint32_t>& marked)
  {
    std::vector<Eigen::Vector3f> positions;
    positions.reserve(marked.size());
    for (const std::uint32_t v : marked)
      positions.push_back(graph.blocks().point(v));
    return positions;
  }

  const Neighbourhood& neighbours(std::uint32_t i)
  {
    Box box;
    box.extend(blocks_.point(i).data());
    search_.setRun(box);
    return search_.find(blocks_.position(i));
  }

  /** The nearest free point, or the first one, that turns little enough. */
  std::optional<std::uint32_t> step(const std::vector<std::uint32_t>& path, double walked)
  {
    const std::uint32_t from = path.back();
    const Eigen::Vector3d p = blocks_.position(from);
    const Eigen::Vector3d came =
        path.size() > 1 ? Eigen::Vector3d(p - blocks_.position(path[path.size() - 2])) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    const bool may_close = walked >= options_.shortest * spacing_;
    const Neighbourhood& near = neighbours(from);
    for (int k = 0; k < near.size; ++k) {
      const std::uint32_t q = near.index[k];
      if (q == from || (taken_[q] && !(may_close && q == path.front())))
        continue;
      const Eigen::Vector3d ahead = blocks_.position(q) - p;
      if (angleBetween(came, ahead) <= options_.max_turn)
        return q;
    }
    return std::nullopt;
  }

  const WalkOptions& options_;
  double spacing_;
  PointBlocks blocks_;
  std::vector<std::uint8_t> taken_;
  NeighbourSearch search_;
};

/** Whether the surface at a ring lies on its left, not on its right. */
bool
surfaceOnLeft(const SurfaceGraph& graph, const Ring& ring)
{
  const Triangulation& mesh = graph.triangulation();
  double left_sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::uint32_t v = ring[i];
    const Eigen::Vector3d along = graph.position(ring[(i + 1) % ring.size()]) - graph.position(ring[(i + ring.size() - 1) % ring.size()]);
    const Eigen::Vector3d left = graph.normal(v).cross(along);
    for (std::uint32_t k = mesh.outgoingBegin(v); k < mesh.outgoingBegin(v + 1); ++k) {
      const std::uint32_t h = mesh.outgoing(k);
      const Eigen::Vector3d middle = 0.5 * (graph.position(mesh.target(h)) + graph.position(mesh.origin(Triangulation::previous(h))));
      left_sum += left.dot(middle - graph.position(v));
    }
  }
  return left_sum >= 0.0;
}

Status
stopped(const Eigen::Vector3d& place, double walked, double reach, double max_turn)
{
  return {StatusCode::Failed,
          Diagnostic("the walk along the boundary ends at ", Place(place), " after ", walked, " {mm}: no other boundary point within ",
                     reach, " {mm} lies ahead with a turn of ", max_turn * 180.0 / pi,
                     " {degrees} or less (a corner, a gap, or a band of several rows); raise the largest turn, or link half-edges")};
}

} // namespace

Status
walkRings(const SurfaceGraph& graph, const std::vector<std::uint32_t>& marked, const WalkOptions& options, std::vector<Ring>& rings,
          std::size_t& left_out)
{
  rings.clear();
  if (marked.empty())
    return Status::success();
  BoundaryWalk walk(graph, marked, options);
  std::vector<std::uint32_t> path;
  while (const auto first = walk.start()) {
    double walked = 0.0;
    if (!walk.walkFrom(*first, path, walked)) {
      if (walked >= options.shortest * graph.spacing())
        return stopped(walk.position(path.back()), walked, options.reach * graph.spacing(), options.max_turn);
      ++left_out;
      continue;
    }
    walk.takeBeside(path);
    Ring ring;
    for (const std::uint32_t i : path)
      ring.push_back(marked[walk.markedIndex(i)]);
    if (!surfaceOnLeft(graph, ring))
      std::reverse(ring.begin(), ring.end());
    rings.push_back(std::move(ring));
  }
  return Status::success();
}

} // namespace pcl_spiral
