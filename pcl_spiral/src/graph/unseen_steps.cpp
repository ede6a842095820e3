// SPDX-License-Identifier: BSD-3-Clause
#include "unseen_steps.h"

#include "local_shape.h"
#include "triangle_pieces.h"

#include "search/neighbour_search.h"
#include "search/pieces.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace pcl_spiral {
namespace {

constexpr float long_edge = 1.8f;       // spacings
constexpr int few = 12;                 // neighbours, all on one side of a step that is three spacings high
constexpr float steep = 0.5f;           // sine of the angle between an edge and the surface at both ends
constexpr float longer_edge = 2.1f;     // spacings: of an edge that is steep at one end, where the other is a steep rim
constexpr float steeper = 0.6f;         // such a sine at the one end
constexpr float slanted = 0.15f;        // and at the other
constexpr float leaning = 0.5f;         // share of these sines that is asked for while normals still lean beside the step
constexpr double large = 0.02;          // of all triangles
constexpr double most_near = 0.1;       // of the points: with more of them, noise or loose points make the steps
constexpr std::size_t least_steps = 16; // up to a small surface, two per edge: fewer lead up from a single point below
constexpr double mostly = 0.9;          // of the step edges at a surface: they lead up to one that stands on another

/** The work of unseenSteps. */
class UnseenSteps {
public:
  UnseenSteps(const TriangulatedPoints& cloud, const Triangulation& mesh) : cloud_(cloud), mesh_(mesh) {}

  std::vector<std::uint8_t> find()
  {
    if (!findNormals() || !findSteps())
      return {};
    findSurfaces();
    widenSurfaces(false);
    findAlone();
    if (std::count(stands_alone_.begin(), stands_alone_.end(), 1) < 2)
      return {};
    for (std::uint32_t& surface : of_point_)
      if (surface != Triangulation::none && !stands_alone_[surface])
        surface = Triangulation::none;
    widenSurfaces(false); // over what does not stand alone
    widenSurfaces(true);  // what only steps lead to, such as single points on the side
    return betweenSurfaces();
  }

private:
  /** How much half-edge \p h rises over a surface with \p normals, -1 to 1, if it is long and steep at both ends, or longer and steeper
   *  at one of them, and slanted at the other, with \p share of the sines asked for; else 0. */
  float rise(std::uint32_t h, const std::vector<Eigen::Vector3f>& normals, float share) const
  {
    const std::uint32_t a = mesh_.origin(h), b = mesh_.target(h);
    const Eigen::Vector3f edge = cloud_.blocks.point(b) - cloud_.blocks.point(a);
    const float squared = edge.squaredNorm(), spacing = cloud_.spacings_per_radius * std::max(cloud_.radii[a], cloud_.radii[b]);
    if (squared <= long_edge * long_edge * spacing * spacing)
      return 0.0f;
    const float length = std::sqrt(squared), at_a = edge.dot(normals[a]) / length, at_b = edge.dot(normals[b]) / length;
    if (!(at_a * at_b > 0.0f))
      return 0.0f; // a bend, no step
    const auto [less, more] = std::minmax({std::abs(at_a), std::abs(at_b)});
    const bool is_steep = less > share * steep,
               leads_to_steep_rim = length > longer_edge * spacing && less > share * slanted && more > share * steeper;
    return is_steep || leads_to_steep_rim ? at_a : 0.0f;
  }
  float rise(std::uint32_t h) const { return rise(h, normals_, 1.0f); }

  /** Calls \p visit for the half-edges of the triangles about point \p v that begin or end there, until it returns true. Returns whether it
   *  did. */
  template <typename Visit>
  bool anyAbout(std::uint32_t v, Visit visit) const
  {
    for (std::uint32_t k = mesh_.outgoingBegin(v); k < mesh_.outgoingBegin(v + 1); ++k)
      if (visit(mesh_.outgoing(k)) || visit(Triangulation::previous(mesh_.outgoing(k))))
        return true;
    return false;
  }

  /** Normals of few neighbours at the ends of edges that may be steps: beside a step, those of more neighbours lean. False if there is no
   *  such edge. */
  bool findNormals()
  {
    std::vector<std::uint8_t> is_end(cloud_.normals.size(), 0);
    forPoints(is_end.size(),
              [&](std::uint32_t v) { is_end[v] = anyAbout(v, [&](std::uint32_t h) { return rise(h, cloud_.normals, leaning) != 0.0f; }); });
    if (std::find(is_end.begin(), is_end.end(), 1) == is_end.end())
      return false;
    normals_ = cloud_.normals;
    const PointBlocks& blocks = cloud_.blocks;
#pragma omp parallel
    {
      NeighbourSearch search(blocks, std::min<int>(few, static_cast<int>(blocks.size())));
#pragma omp for schedule(dynamic, 64)
      for (std::int64_t b = 0; b < static_cast<std::int64_t>(blocks.blockCount()); ++b) {
        bool started = false;
        for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i) {
          if (is_end[i] == 0)
            continue;
          if (!started)
            search.setRun(blocks.blockBox(b));
          started = true;
          const Eigen::Vector3f normal = localShape(search.find(blocks.position(i))).normal.cast<float>();
          normals_[i] = normal.dot(normals_[i]) < 0.0f ? Eigen::Vector3f(-normal) : normal;
        }
      }
    }
    return true;
  }

  /** Flags the points of triangles with a step; false if there is none, or too many for the rim of a part. */
  bool findSteps()
  {
    std::vector<std::uint8_t> is_step(mesh_.triangleCount(), 0);
    forPoints(is_step.size(),
              [&](std::uint32_t t) { is_step[t] = rise(3 * t) != 0.0f || rise(3 * t + 1) != 0.0f || rise(3 * t + 2) != 0.0f; });
    near_step_.assign(normals_.size(), 0);
    forPoints(near_step_.size(),
              [&](std::uint32_t v) { near_step_[v] = anyAbout(v, [&](std::uint32_t h) { return is_step[h / 3] != 0; }); });
    const auto near = static_cast<double>(std::count(near_step_.begin(), near_step_.end(), 1));
    return near > 0.0 && near <= most_near * static_cast<double>(near_step_.size());
  }

  bool isAtStep(std::uint32_t t) const
  {
    const auto& [a, b, c] = mesh_.triangle(t);
    return near_step_[a] || near_step_[b] || near_step_[c];
  }

  /** The surfaces without the triangles at steps, where a single one that is no step could join two: sizes_, and of_point_. */
  void findSurfaces()
  {
    of_point_.assign(cloud_.blocks.size(), Triangulation::none);
    const std::vector<std::uint32_t> surface = trianglePieces(
        mesh_, [this](std::uint32_t t) { return !isAtStep(t); }, sizes_);
    for (std::uint32_t h = 0; h < mesh_.halfEdgeCount(); ++h)
      if (surface[h / 3] != Triangulation::none)
        of_point_[mesh_.origin(h)] = surface[h / 3];
  }

  /** Gives each point without a surface that one, of those that edges lead to, from whose nearest plane it is least far off. With
   *  \p over_steps also steps are such edges. */
  void widenSurfaces(bool over_steps)
  {
    struct Reached {
      float off;                 ///< the plane of the seed
      std::uint32_t point, seed; ///< seed: a point that had a surface
      bool operator<(const Reached& other) const
      {
        return std::tie(off, point, seed) > std::tie(other.off, other.point, other.seed); // the least on top of the queue
      }
    };
    std::priority_queue<Reached> reached;
    const auto reachAbout = [&](std::uint32_t v, std::uint32_t seed) {
      anyAbout(v, [&](std::uint32_t h) {
        const std::uint32_t other = mesh_.origin(h) == v ? mesh_.target(h) : mesh_.origin(h);
        if (of_point_[other] == Triangulation::none && (over_steps || rise(h) == 0.0f)) {
          const Eigen::Vector3f away = cloud_.blocks.point(other) - cloud_.blocks.point(seed);
          reached.push({std::abs(away.dot(normals_[seed])), other, seed});
        }
        return false;
      });
    };
    for (std::uint32_t v = 0; v < of_point_.size(); ++v)
      if (of_point_[v] != Triangulation::none)
        reachAbout(v, v);
    while (!reached.empty()) {
      const Reached next = reached.top();
      reached.pop();
      if (of_point_[next.point] != Triangulation::none)
        continue;
      of_point_[next.point] = of_point_[next.seed];
      reachAbout(next.point, next.seed);
    }
  }

  /** Which surfaces stand alone: large ones, and small ones above what is around them. */
  void findAlone()
  {
    std::vector<std::size_t> up(sizes_.size(), 0), down(sizes_.size(), 0); // steps that lead to a surface from below, from above
    for (std::uint32_t h = 0; h < mesh_.halfEdgeCount(); ++h) {
      const std::uint32_t from = of_point_[mesh_.origin(h)], to = of_point_[mesh_.target(h)];
      const float height = from != to && from != Triangulation::none && to != Triangulation::none ? rise(h) : 0.0f;
      if (height == 0.0f)
        continue;
      ++(height > 0.0f ? up : down)[to];
      ++(height > 0.0f ? down : up)[from];
    }
    stands_alone_.resize(sizes_.size());
    for (std::size_t s = 0; s < sizes_.size(); ++s)
      stands_alone_[s] = static_cast<double>(sizes_[s]) >= large * static_cast<double>(mesh_.triangleCount()) ||
                         (sizes_[s] >= least_surface && up[s] >= least_steps &&
                          static_cast<double>(up[s]) > mostly * static_cast<double>(up[s] + down[s]));
  }

  /** Flags the triangles with corners on two surfaces. */
  std::vector<std::uint8_t> betweenSurfaces() const
  {
    std::vector<std::uint8_t> removed(mesh_.triangleCount(), 0);
    forPoints(removed.size(), [&](std::uint32_t t) {
      const auto& [a, b, c] = mesh_.triangle(t);
      removed[t] = of_point_[a] != of_point_[b] || of_point_[b] != of_point_[c];
    });
    return removed;
  }

  const TriangulatedPoints& cloud_;
  const Triangulation& mesh_;
  std::vector<Eigen::Vector3f> normals_;
  std::vector<std::uint8_t> near_step_;    // of points: a corner of a triangle with a step
  std::vector<std::size_t> sizes_;         // of surfaces, triangles
  std::vector<std::uint32_t> of_point_;    // surface of each point
  std::vector<std::uint8_t> stands_alone_; // of surfaces
};

} // namespace

std::vector<std::uint8_t>
unseenSteps(const TriangulatedPoints& cloud, const Triangulation& mesh)
{
  return UnseenSteps(cloud, mesh).find();
}

} // namespace pcl_spiral
