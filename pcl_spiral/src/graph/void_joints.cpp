// SPDX-License-Identifier: BSD-3-Clause
#include "void_joints.h"

#include "triangle_pieces.h"

#include "search/pieces.h"
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace pcl_spiral {
namespace {

constexpr float sharpest_corner = 0.25f; // of a full turn: a corner of 90 degrees
constexpr float reentrant = 0.75f;       // the same of one of 270: where more is filled, the offset is noise
constexpr double most_voids = 0.1;       // of the triangles: more are the pattern of the scan, lines far apart
constexpr std::size_t few_steps = 64;    // triangles walked over for each one about a void; no result depends on it

/** The work of voidJoints. */
class VoidJoints {
public:
  VoidJoints(const TriangulatedPoints& cloud, const std::vector<float>& offsets, double max_circumradius, const Triangulation& mesh)
  : cloud_(cloud), offsets_(offsets), mesh_(mesh), widest_(static_cast<float>(2.0 * max_circumradius) * cloud.spacings_per_radius)
  {}

  std::vector<std::uint8_t> find()
  {
    findVoids();
    const auto voids = static_cast<double>(std::count(is_void_.begin(), is_void_.end(), 1));
    if (voids > most_voids * static_cast<double>(is_void_.size()) || leadAround())
      return {};
    findSurfaces();
    return between();
  }

private:
  /** Flags the triangles over a void: an edge is longer than the widest void that is surface, by the spacing at both ends. */
  void findVoids()
  {
    is_void_.assign(mesh_.triangleCount(), 0);
    forPoints(is_void_.size(), [&](std::uint32_t t) {
      const Triangulation::Triangle& v = mesh_.triangle(t);
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t a = v[i], b = v[(i + 1) % 3];
        const float squared = (cloud_.blocks.point(b) - cloud_.blocks.point(a)).squaredNorm();
        is_void_[t] |= isWide(squared, a) && isWide(squared, b);
      }
    });
  }

  /** Whether all that is about the voids is connected beside them within a few triangles, as about a notch of a rim. Then they join
   *  nothing, and there is no need to walk over the whole mesh. */
  bool leadAround() const
  {
    std::unordered_set<std::uint32_t> seen;
    for (std::uint32_t t = 0; t < is_void_.size(); ++t)
      if (is_void_[t] && seen.insert(t).second && !leadsAround(voidWith(t, seen)))
        return false;
    return true;
  }

  /** The triangles over the void of triangle \p t, by edges; put into \p seen. */
  std::vector<std::uint32_t> voidWith(std::uint32_t t, std::unordered_set<std::uint32_t>& seen) const
  {
    std::vector<std::uint32_t> all{t};
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::uint32_t h = 3 * all[i]; h < 3 * all[i] + 3; ++h)
        if (const std::uint32_t other = mesh_.opposite(h);
            other != Triangulation::none && is_void_[other / 3] && seen.insert(other / 3).second)
          all.push_back(other / 3);
    return all;
  }

  /** The same of the void under these triangles. */
  bool leadsAround(const std::vector<std::uint32_t>& over_void) const
  {
    std::unordered_set<std::uint32_t> about; // not over a void, at its points
    for (const std::uint32_t t : over_void)
      for (const std::uint32_t v : mesh_.triangle(t))
        for (std::uint32_t k = mesh_.outgoingBegin(v); k < mesh_.outgoingBegin(v + 1); ++k)
          if (const std::uint32_t other = mesh_.outgoing(k) / 3; !is_void_[other])
            about.insert(other);
    if (about.empty())
      return true;
    const std::size_t most = few_steps * about.size();
    std::vector<std::uint32_t> walk{*about.begin()};
    std::unordered_set<std::uint32_t> seen{walk.front()};
    std::size_t found = 1;
    for (std::size_t i = 0; i < walk.size() && found < about.size() && walk.size() < most; ++i)
      for (std::uint32_t h = 3 * walk[i]; h < 3 * walk[i] + 3; ++h)
        if (const std::uint32_t other = mesh_.opposite(h);
            other != Triangulation::none && !is_void_[other / 3] && seen.insert(other / 3).second) {
          walk.push_back(other / 3);
          found += about.count(other / 3);
        }
    return found == about.size();
  }

  /** Whether a void of this width, squared, at point \p v is no surface. */
  bool isWide(float squared, std::uint32_t v) const
  {
    const float most = widest_ * cloud_.radii[v];
    return squared > sharpest_corner * most * most && squared > filledShare(offsets_[v]) * most * most;
  }

  /** Distance of the centroid of a sector with this share of a disc from the middle, in radii: 2/3 sin(a/2) / (a/2) for the angle a. */
  static float centroidOf(float share)
  {
    const float half = static_cast<float>(pi) * share;
    return 2.0f / 3.0f * std::sin(half) / half;
  }

  /** The share of its circle that a neighbourhood fills, from the distance of its mean from the middle, in radii. */
  static float filledShare(float offset)
  {
    if (offset < centroidOf(reentrant))
      return 1.0f;
    float least = sharpest_corner, most = reentrant;
    for (int i = 0; i < 16; ++i) {
      const float share = 0.5f * (least + most);
      (centroidOf(share) > offset ? least : most) = share;
    }
    return least;
  }

  float longestSquared(std::uint32_t t) const
  {
    const Triangulation::Triangle& v = mesh_.triangle(t);
    const Eigen::Vector3f a = cloud_.blocks.point(v[0]), b = cloud_.blocks.point(v[1]), c = cloud_.blocks.point(v[2]);
    return std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  }

  /** The surfaces without the triangles over voids. A point is of the one whose triangle there has the least longest edge; loose points are
   *  of none. */
  void findSurfaces()
  {
    std::vector<std::size_t> sizes;
    std::vector<std::uint32_t> surface = trianglePieces(
        mesh_, [&](std::uint32_t t) { return !is_void_[t]; }, sizes);
    is_loose_.assign(mesh_.triangleCount(), 0);
    for (std::uint32_t t = 0; t < surface.size(); ++t)
      if (surface[t] != Triangulation::none && sizes[surface[t]] < least_surface) {
        is_loose_[t] = 1;
        surface[t] = Triangulation::none;
      }
    of_point_.assign(cloud_.blocks.size(), Triangulation::none);
    forPoints(of_point_.size(), [&](std::uint32_t v) {
      float least = 0.0f;
      for (std::uint32_t k = mesh_.outgoingBegin(v); k < mesh_.outgoingBegin(v + 1); ++k) {
        const std::uint32_t t = mesh_.outgoing(k) / 3;
        const float longest = longestSquared(t);
        if (surface[t] != Triangulation::none && (of_point_[v] == Triangulation::none || longest < least)) {
          least = longest;
          of_point_[v] = surface[t];
        }
      }
    });
  }

  /** Flags the triangles over voids that lead, alone or by others of them and loose points, to more than one surface, and triangles beside
   *  them with corners on two surfaces, which are just not long enough. */
  std::vector<std::uint8_t> between() const
  {
    std::vector<std::size_t> sizes;
    const std::vector<std::uint32_t> bridge = trianglePieces(
        mesh_, [&](std::uint32_t t) { return is_void_[t] || is_loose_[t]; }, sizes);
    std::vector<std::uint32_t> first(sizes.size(), Triangulation::none);
    std::vector<std::uint8_t> joins(sizes.size(), 0);
    for (std::uint32_t h = 0; h < mesh_.halfEdgeCount(); ++h) {
      const std::uint32_t b = bridge[h / 3], surface = of_point_[mesh_.origin(h)];
      if (b == Triangulation::none || surface == Triangulation::none)
        continue;
      if (first[b] == Triangulation::none)
        first[b] = surface;
      joins[b] |= first[b] != surface;
    }
    if (std::find(joins.begin(), joins.end(), 1) == joins.end())
      return {};
    std::vector<std::uint8_t> at_joint(of_point_.size(), 0), removed(mesh_.triangleCount(), 0);
    for (std::uint32_t t = 0; t < removed.size(); ++t)
      if (is_void_[t] && joins[bridge[t]]) {
        removed[t] = 1;
        for (const std::uint32_t v : mesh_.triangle(t))
          at_joint[v] = 1;
      }
    forPoints(removed.size(), [&](std::uint32_t t) {
      const auto& [a, b, c] = mesh_.triangle(t);
      removed[t] |= (at_joint[a] || at_joint[b] || at_joint[c]) && (areTwo(a, b) || areTwo(b, c) || areTwo(c, a));
    });
    return removed;
  }

  /** Whether points \p a and \p b are of two surfaces. */
  bool areTwo(std::uint32_t a, std::uint32_t b) const
  {
    return of_point_[a] != of_point_[b] && of_point_[a] != Triangulation::none && of_point_[b] != Triangulation::none;
  }

  const TriangulatedPoints& cloud_;
  const std::vector<float>& offsets_;
  const Triangulation& mesh_;
  float widest_;                        ///< void that is surface, times the radius of a full neighbourhood
  std::vector<std::uint8_t> is_void_;   ///< of triangles
  std::vector<std::uint8_t> is_loose_;  ///< of triangles: between so few others that they are no surface
  std::vector<std::uint32_t> of_point_; ///< the surface of each point
};

} // namespace

std::vector<std::uint8_t>
voidJoints(const TriangulatedPoints& cloud, const std::vector<float>& offsets, double max_circumradius, const Triangulation& mesh)
{
  return VoidJoints(cloud, offsets, max_circumradius, mesh).find();
}

} // namespace pcl_spiral
