// SPDX-License-Identifier: BSD-3-Clause
#include "unseen_steps.h"

#include "local_shape.h"

#include "search/neighbour_search.h"
#include "search/pieces.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr std::uint32_t none = Triangulation::none;
constexpr float long_edge = 1.8f;      // spacings
constexpr int few = 12;                // neighbours, all on one side of a step that is three spacings high
constexpr float steep = 0.5f;          // sine of the angle between an edge and the surface at both ends
constexpr float perhaps_steep = 0.25f; // the same with normals that lean beside the step
constexpr double large = 0.02;         // of all triangles
constexpr double mostly = 0.9;         // of the edges between two surfaces

/** The work of removeUnseenSteps. */
class UnseenSteps {
public:
  UnseenSteps(const TriangulatedPoints& cloud, const Triangulation& mesh) : cloud_(cloud), mesh_(mesh) {}

  /** One flag per triangle, 1 if it is to be removed; empty if none is. */
  std::vector<std::uint8_t> find()
  {
    if (!flagSteps())
      return {};
    findSurfaces();
    if (std::count(stands_alone_.begin(), stands_alone_.end(), 1) < 2)
      return {};
    return betweenSurfaces();
  }

private:
  /** How much half-edge \p h rises over a surface with \p normals, -1 to 1, if it is long and steeper than \p least at both ends;
   *  else 0. */
  float rise(std::uint32_t h, const std::vector<Eigen::Vector3f>& normals, float least) const
  {
    const std::uint32_t a = mesh_.origin(h), b = mesh_.target(h);
    const Eigen::Vector3f edge = cloud_.blocks.point(b) - cloud_.blocks.point(a);
    const float squared = edge.squaredNorm(), enough = long_edge * cloud_.spacings_per_radius * std::max(cloud_.radii[a], cloud_.radii[b]);
    if (squared <= enough * enough)
      return 0.0f;
    const float length = std::sqrt(squared), at_a = edge.dot(normals[a]) / length, at_b = edge.dot(normals[b]) / length;
    return at_a * at_b > 0.0f && std::min(std::abs(at_a), std::abs(at_b)) > least ? at_a : 0.0f;
  }
  float rise(std::uint32_t h) const { return rise(h, normals_, steep); }

  /** Normals of few neighbours at the ends of edges that may be steps: beside a step, those of more neighbours lean. False if there is no
   *  such edge. */
  bool findNormals()
  {
    std::vector<std::uint8_t> is_end(cloud_.normals.size(), 0);
    const auto mayStep = [&](std::uint32_t h) { return rise(h, cloud_.normals, perhaps_steep) != 0.0f; };
    forPoints(is_end.size(), [&](std::uint32_t v) {
      for (std::uint32_t k = mesh_.outgoingBegin(v); k < mesh_.outgoingBegin(v + 1) && is_end[v] == 0; ++k)
        is_end[v] = mayStep(mesh_.outgoing(k)) || mayStep(Triangulation::previous(mesh_.outgoing(k)));
    });
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

  /** Flags the triangles over steps; false if there is none. */
  bool flagSteps()
  {
    if (!findNormals())
      return false;
    is_step_.assign(mesh_.triangleCount(), 0);
    forPoints(is_step_.size(),
              [&](std::uint32_t t) { is_step_[t] = rise(3 * t) != 0.0f || rise(3 * t + 1) != 0.0f || rise(3 * t + 2) != 0.0f; });
    return std::find(is_step_.begin(), is_step_.end(), 1) != is_step_.end();
  }

  /** Calls \p visit for each triangle of the connected region of \p t in which \p belongs, which \p visit must end. */
  template <typename Belongs, typename Visit>
  void flood(std::uint32_t t, Belongs belongs, Visit visit)
  {
    visit(t);
    stack_.assign(1, t);
    while (!stack_.empty()) {
      const std::uint32_t from = stack_.back();
      stack_.pop_back();
      for (std::uint32_t h = 3 * from; h < 3 * from + 3; ++h)
        if (const std::uint32_t other = mesh_.opposite(h); other != none && belongs(other / 3)) {
          visit(other / 3);
          stack_.push_back(other / 3);
        }
    }
  }

  /** The surfaces between steps, and which of them stand alone: large ones, and small ones above what is around them. */
  void findSurfaces()
  {
    std::vector<std::size_t> sizes;
    surface_.assign(mesh_.triangleCount(), none);
    for (std::uint32_t t = 0; t < mesh_.triangleCount(); ++t) {
      if (is_step_[t] || surface_[t] != none)
        continue;
      const auto number = static_cast<std::uint32_t>(sizes.size());
      sizes.push_back(0);
      flood(
          t, [&](std::uint32_t other) { return !is_step_[other] && surface_[other] == none; },
          [&](std::uint32_t other) {
            surface_[other] = number;
            ++sizes[number];
          });
    }
    of_point_.assign(cloud_.blocks.size(), none);
    for (std::uint32_t h = 0; h < mesh_.halfEdgeCount(); ++h)
      if (surface_[h / 3] != none)
        of_point_[mesh_.origin(h)] = surface_[h / 3];
    std::vector<std::size_t> up(sizes.size(), 0), down(sizes.size(), 0); // edges that lead to a surface from below, from above
    for (std::uint32_t h = 0; h < mesh_.halfEdgeCount(); ++h) {
      if (!is_step_[h / 3])
        continue;
      const std::uint32_t from = of_point_[mesh_.origin(h)], to = of_point_[mesh_.target(h)];
      const float height = from != to && from != none && to != none ? rise(h) : 0.0f;
      if (height == 0.0f)
        continue;
      ++(height > 0.0f ? up : down)[to];
      ++(height > 0.0f ? down : up)[from];
    }
    stands_alone_.resize(sizes.size());
    for (std::size_t s = 0; s < sizes.size(); ++s)
      stands_alone_[s] = static_cast<double>(sizes[s]) >= large * static_cast<double>(mesh_.triangleCount()) ||
                         static_cast<double>(up[s]) > mostly * static_cast<double>(up[s] + down[s]);
  }

  bool isAlone(std::uint32_t surface) const
  {
    return surface != none && stands_alone_[surface] != 0;
  }

  /** Flags each region between surfaces that stand alone, if it has corners on two of them. */
  std::vector<std::uint8_t> betweenSurfaces()
  {
    std::vector<std::uint8_t> seen(mesh_.triangleCount(), 0), removed(mesh_.triangleCount(), 0);
    std::vector<std::uint32_t> region;
    for (std::uint32_t t = 0; t < mesh_.triangleCount(); ++t) {
      if (seen[t] || isAlone(surface_[t]))
        continue;
      region.clear();
      std::uint32_t first = none;
      bool joins = false;
      flood(
          t, [&](std::uint32_t other) { return !seen[other] && !isAlone(surface_[other]); },
          [&](std::uint32_t inside) {
            seen[inside] = 1;
            region.push_back(inside);
            for (const std::uint32_t corner : mesh_.triangle(inside))
              if (const std::uint32_t other = of_point_[corner]; isAlone(other)) {
                joins = joins || (first != none && first != other);
                first = other;
              }
          });
      if (joins)
        for (const std::uint32_t inside : region)
          removed[inside] = 1;
    }
    return removed;
  }

  const TriangulatedPoints& cloud_;
  const Triangulation& mesh_;
  std::vector<Eigen::Vector3f> normals_;
  std::vector<std::uint8_t> is_step_;      // of triangles
  std::vector<std::uint32_t> surface_;     // of triangles; none on steps
  std::vector<std::uint32_t> of_point_;    // surface of each point; none of those on steps only
  std::vector<std::uint8_t> stands_alone_; // of surfaces
  std::vector<std::uint32_t> stack_;
};

} // namespace

void
removeUnseenSteps(const TriangulatedPoints& cloud, Triangulation& mesh)
{
  const std::vector<std::uint8_t> removed = UnseenSteps(cloud, mesh).find();
  if (std::find(removed.begin(), removed.end(), 1) == removed.end())
    return;
  std::vector<Triangulation::Triangle> kept;
  for (std::uint32_t t = 0; t < removed.size(); ++t)
    if (!removed[t])
      kept.push_back(mesh.triangle(t));
  mesh = Triangulation(cloud.blocks.size(), kept);
}

} // namespace pcl_spiral
