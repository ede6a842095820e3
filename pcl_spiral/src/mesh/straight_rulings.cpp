// SPDX-License-Identifier: BSD-3-Clause
#include "straight_rulings.h"

#include "straight_ends.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
constexpr std::uint32_t none = Triangulation::none;

/** Calls \p see with each edge at the vertex of sector \p s, as the vector that leaves it and a half-edge on it. */
template <typename See>
void
forEachEdge(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors, std::uint32_t s, See see)
{
  for (std::uint32_t k = sectors.begin[s]; k < sectors.begin[s + 1]; ++k) {
    const std::uint32_t leaving = sectors.corners[k], arriving = Triangulation::previous(leaving);
    const Vector3d& at = positions[mesh.origin(leaving)];
    see(Vector3d(positions[mesh.target(leaving)] - at), leaving);
    see(Vector3d(positions[mesh.origin(arriving)] - at), arriving);
  }
}

/** How far the edges of a sector within 60 degrees of a direction, or of its opposite, go along it, mm. */
struct Extent {
  double shortest_ahead = std::numeric_limits<double>::infinity();
  double longest_behind = 0.0;
};

Extent
extentAlong(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors, std::uint32_t s,
            const Vector3d& direction)
{
  constexpr double least_cosine = 0.5;
  Extent extent;
  forEachEdge(mesh, positions, sectors, s, [&](const Vector3d& edge, std::uint32_t) {
    const double along = edge.dot(direction);
    if (along > least_cosine * edge.norm())
      extent.shortest_ahead = std::min(extent.shortest_ahead, along);
    else if (-along > least_cosine * edge.norm())
      extent.longest_behind = std::max(extent.longest_behind, -along);
  });
  return extent;
}

/** The vector of the edge at vertex \p v that goes on most straight from the unit \p along, and its far vertex; none if none does, or a
 *  crease or the boundary is in the way. */
std::pair<Vector3d, std::uint32_t>
continuation(const Triangulation& mesh, const std::vector<Vector3d>& positions, const std::vector<std::uint8_t>& creases, std::uint32_t v,
             const Vector3d& along)
{
  constexpr double beside = 0.8; // cosine: 37 degrees
  std::pair<Vector3d, std::uint32_t> best{Vector3d::Zero(), none};
  double most = beside;
  for (std::uint32_t k = mesh.outgoingBegin(v); k < mesh.outgoingBegin(v + 1); ++k) {
    const std::uint32_t h = mesh.outgoing(k);
    if (mesh.opposite(h) == none || creases[h])
      return {Vector3d::Zero(), none};
    const Vector3d edge = positions[mesh.target(h)] - positions[v];
    if (const double cosine = edge.normalized().dot(along); cosine > most) {
      most = cosine;
      best = {edge, mesh.target(h)};
    }
  }
  return best;
}

/** Finds the straight edges of sectors. */
class RulingFinder {
public:
  RulingFinder(const Triangulation& mesh, const std::vector<Vector3d>& positions, const std::vector<std::uint8_t>& creases,
               const CornerSectors& sectors, const FlatRegions& regions)
  : mesh_(mesh), positions_(positions), creases_(creases), sectors_(sectors), regions_(regions), faces_(regions.normals.size(), 0)
  {
    for (const std::uint32_t g : regions.of_face)
      ++faces_[g];
  }

  /** The \p normal of sector \p s, perpendicular to the straight edge that it leans towards most, if there is one. */
  Vector3d straightened(std::uint32_t s, const Vector3d& normal) const
  {
    Vector3d found = normal;
    double most = 0.0;
    forEachEdge(mesh_, positions_, sectors_, s, [&](const Vector3d& edge, std::uint32_t h) {
      if (regions_.isInside(mesh_, h) || std::abs(normal.dot(edge)) <= most || !isStraight(s, edge, h))
        return; // inside: a diagonal, which the mesher was free to draw
      const Vector3d along = edge.normalized();
      most = std::abs(normal.dot(edge));
      found = (normal - normal.dot(along) * along).normalized();
    });
    return found;
  }

private:
  bool isStraight(std::uint32_t s, const Vector3d& edge, std::uint32_t h) const
  {
    if (!isBetweenPlanes(h))
      return false; // triangles with random corners have edges of all lengths; faces of four corners in a plane are a pattern
    const Vector3d along = edge.normalized();
    Extent extent = extentAlong(mesh_, positions_, sectors_, s, along);
    const bool leaves = sectors_.of_corner[h] == s;
    if (extent.longest_behind == 0.0) { // the mesh ends here: the other end tells
      const std::uint32_t far = leaves ? Triangulation::next(h) : h;
      extent.longest_behind = extentAlong(mesh_, positions_, sectors_, sectors_.of_corner[far], -along).longest_behind;
    }
    return extent.longest_behind > 0.0 &&
           endsStraight(extent.shortest_ahead / extent.longest_behind, bendShare(leaves ? mesh_.origin(h) : mesh_.target(h), along));
  }

  bool isBetweenPlanes(std::uint32_t h) const
  {
    const std::uint32_t other = mesh_.opposite(h);
    return faces_[regions_.of_face[h / 3]] >= 2 && (other == none || faces_[regions_.of_face[other / 3]] >= 2);
  }

  /** See endsStraight(), for an edge that leaves vertex \p v. */
  double bendShare(std::uint32_t v, const Vector3d& along) const
  {
    const auto [first, middle] = continuation(mesh_, positions_, creases_, v, -along);
    if (middle == none)
      return std::nan("");
    const auto [second, end] = continuation(mesh_, positions_, creases_, middle, first.normalized());
    if (end == none)
      return std::nan("");
    const Vector3d bend = -along - first.normalized(), next_bend = first.normalized() - second.normalized();
    return bend.dot(next_bend) / next_bend.squaredNorm() * (first.norm() + second.norm()) / first.norm();
  }

  const Triangulation& mesh_;
  const std::vector<Vector3d>& positions_;
  const std::vector<std::uint8_t>& creases_;
  const CornerSectors& sectors_;
  const FlatRegions& regions_;
  std::vector<std::uint32_t> faces_; ///< of each region
};

} // namespace

void
straightenRulings(const Triangulation& mesh, const std::vector<Vector3d>& positions, const std::vector<std::uint8_t>& creases,
                  const CornerSectors& sectors, const FlatRegions& regions, std::vector<Vector3d>& normals)
{
  const RulingFinder finder(mesh, positions, creases, sectors, regions);
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(sectors.count()); ++i) {
    const auto s = static_cast<std::uint32_t>(i);
    const auto begin = sectors.corners.begin() + sectors.begin[s], end = sectors.corners.begin() + sectors.begin[s + 1];
    if (std::none_of(begin, end, [&](std::uint32_t h) { return regions.flatAt(h / 3) != none; }))
      normals[s] = finder.straightened(s, normals[s]);
  }
}

} // namespace pcl_spiral
