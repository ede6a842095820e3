// SPDX-License-Identifier: BSD-3-Clause
#include "star_triangles.h"

#include "search/pieces.h"

#include <algorithm>
#include <limits>
#include <unordered_set>

namespace pcl_spiral {
namespace {

using Triangle = Triangulation::Triangle;

/** A number of triangles with those added later. */
std::size_t
withRoom(std::size_t count)
{
  return count + count / 64;
}

/** Which corner of the triangle (v, a, b) \p v is; the first corner is the smallest. */
std::uint32_t
cornerOf(std::uint32_t v, std::uint32_t a, std::uint32_t b)
{
  return v < a && v < b ? 0 : a < b ? 2 : 1;
}

/** For each slot, the half-edge that leaves the star's point along the spoke, in the triangle all corners agree on; none if there is
 *  none. Triangles are numbered by their smallest corner, so that those of one place lie together. */
std::vector<std::uint32_t>
agreedHalfEdges(const StarSet& stars, std::size_t& triangle_count)
{
  std::vector<std::uint32_t> half_edge(stars.spokes.size(), Triangulation::none); // at first the number of the triangle in its piece
  std::vector<std::uint32_t> first(pieceCount(stars.size()) + 1, 0);              // of each piece
  forPoints(stars.size(), [&](std::uint32_t v) {
    std::uint32_t& own = first[v / piece_size + 1];
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot) {
      const std::uint32_t a = stars.neighbourAt(slot), b = stars.neighbourAt(stars.slotAfter(v, slot));
      if (!stars.hasTriangle(slot) || a < v || b < v)
        continue;
      const std::uint32_t at_a = stars.slotOf(a, b, v), at_b = stars.slotOf(b, v, a);
      if (at_a != Triangulation::none && at_b != Triangulation::none)
        half_edge[slot] = half_edge[at_a] = half_edge[at_b] = own++;
    }
  });
  for (std::size_t p = 1; p < first.size(); ++p)
    first[p] += first[p - 1];
  forPoints(stars.size(), [&](std::uint32_t v) {
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot) {
      if (half_edge[slot] == Triangulation::none)
        continue;
      const std::uint32_t a = stars.neighbourAt(slot), b = stars.neighbourAt(stars.slotAfter(v, slot));
      half_edge[slot] = 3 * (half_edge[slot] + first[std::min({v, a, b}) / piece_size]) + cornerOf(v, a, b);
    }
  });
  triangle_count = first.back();
  return half_edge;
}

/** The triangles all corners agree on. */
std::vector<Triangle>
agreedTriangles(const StarSet& stars, const std::vector<std::uint32_t>& half_edge, std::size_t count)
{
  std::vector<Triangle> triangles;
  triangles.reserve(withRoom(count));
  triangles.resize(count);
  forPoints(stars.size(), [&](std::uint32_t v) {
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot)
      if (const std::uint32_t own = half_edge[slot]; own != Triangulation::none && own % 3 == 0)
        triangles[own / 3] = {v, stars.neighbourAt(slot), stars.neighbourAt(stars.slotAfter(v, slot))};
  });
  return triangles;
}

/** The opposite of each half-edge of the \p count triangles all corners agree on: neighbours in a star are neighbours in the mesh. */
std::vector<std::uint32_t>
agreedOpposites(const StarSet& stars, const std::vector<std::uint32_t>& half_edge, std::size_t count)
{
  std::vector<std::uint32_t> opposite;
  opposite.reserve(3 * withRoom(count));
  opposite.resize(3 * count, Triangulation::none);
  forPoints(stars.size(), [&](std::uint32_t v) {
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot) {
      const std::uint32_t own = half_edge[slot], before = half_edge[stars.slotBefore(v, slot)];
      if (own != Triangulation::none && before != Triangulation::none) // of (v, z, a), where the own one is v - a
        opposite[own] = Triangulation::previous(before);
    }
  });
  return opposite;
}

/** Closes the gaps of slots without a triangle. After this, \p begin is where the half-edges of each point start. */
void
compact(const StarSet& stars, std::vector<std::uint32_t>& half_edge, std::vector<std::uint32_t>& begin)
{
  std::uint32_t kept = 0;
  begin.assign(stars.size() + 1, 0);
  for (std::size_t v = 0; v < stars.size(); ++v) {
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot)
      if (half_edge[slot] != Triangulation::none)
        half_edge[kept++] = half_edge[slot];
    begin[v + 1] = kept;
  }
  half_edge.resize(kept);
}

struct Candidate {
  Triangle corners;
  int votes;
  float size; ///< its sides, squared
};

/** Triangles that not all corners agree on, each named by the smallest corner that has it; most votes first, then the
 *  smallest. */
std::vector<Candidate>
disputedTriangles(const std::vector<Eigen::Vector3f>& points, const StarSet& stars, const std::vector<std::uint32_t>& half_edge)
{
  const auto squared = [&](std::uint32_t a, std::uint32_t b) { return (points[a] - points[b]).squaredNorm(); };
  std::vector<std::vector<Candidate>> found(pieceCount(stars.size()));
  forPoints(stars.size(), [&](std::uint32_t v) {
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot) {
      if (!stars.hasTriangle(slot) || half_edge[slot] != Triangulation::none)
        continue;
      const std::uint32_t a = stars.neighbourAt(slot), b = stars.neighbourAt(stars.slotAfter(v, slot));
      const bool in_a = stars.slotOf(a, b, v) != Triangulation::none, in_b = stars.slotOf(b, v, a) != Triangulation::none;
      if (!(in_a && a < v) && !(in_b && b < v))
        found[v / piece_size].push_back({{v, a, b}, 1 + in_a + in_b, squared(v, a) + squared(a, b) + squared(b, v)});
    }
  });
  std::vector<Candidate> disputed;
  for (const auto& part : found)
    disputed.insert(disputed.end(), part.begin(), part.end());
  std::stable_sort(disputed.begin(), disputed.end(),
                   [](const Candidate& a, const Candidate& b) { return a.votes > b.votes || (a.votes == b.votes && a.size < b.size); });
  return disputed;
}

/** Those candidates, in their order, whose half-edges are still free. */
std::vector<Triangle>
settle(const std::vector<Candidate>& candidates, const Triangulation& mesh)
{
  std::unordered_set<std::uint64_t> taken;
  const auto key = [](std::uint32_t from, std::uint32_t to) { return static_cast<std::uint64_t>(from) << 32 | to; };
  const auto isFree = [&](std::uint32_t from, std::uint32_t to) {
    for (std::uint32_t i = mesh.outgoingBegin(from); i < mesh.outgoingBegin(from + 1); ++i)
      if (mesh.target(mesh.outgoing(i)) == to)
        return false;
    return taken.count(key(from, to)) == 0;
  };
  std::vector<Triangle> accepted;
  for (const auto& [t, votes, size] : candidates) {
    if (!isFree(t[0], t[1]) || !isFree(t[1], t[2]) || !isFree(t[2], t[0]))
      continue;
    for (int i = 0; i < 3; ++i)
      taken.insert(key(t[i], t[(i + 1) % 3]));
    accepted.push_back(t);
  }
  return accepted;
}

/** The entry of a closed loop with the smallest sum of distances to the others. */
std::size_t
mostCentral(const std::vector<Eigen::Vector3f>& points, const Triangulation& mesh, const std::vector<std::uint32_t>& loop)
{
  std::size_t best = 0;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    float sum = 0.0f;
    for (const std::uint32_t h : loop)
      sum += (points[mesh.origin(h)] - points[mesh.origin(loop[i])]).squaredNorm();
    if (sum < least) {
      least = sum;
      best = i;
    }
  }
  return best;
}

/** Triangles for the short closed loops of free half-edges that remain where stars disagree. */
std::vector<Triangle>
pinholeTriangles(const std::vector<Eigen::Vector3f>& points, const Triangulation& mesh, int pinhole_edges)
{
  std::vector<Triangle> triangles;
  for (auto& loop : mesh.boundaryLoops()) {
    const int m = static_cast<int>(loop.size());
    if (m < 3 || m > pinhole_edges)
      continue;
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(mostCentral(points, mesh, loop)), loop.end());
    // The hole lies on the right of the loop's half-edges: go round it backwards, as a fan about its first point.
    for (int i = 1; i + 1 < m; ++i)
      triangles.push_back({mesh.origin(loop[0]), mesh.origin(loop[i + 1]), mesh.origin(loop[i])});
  }
  return triangles;
}

} // namespace

Triangulation
triangulate(const std::vector<Eigen::Vector3f>& points, StarSet stars, int pinhole_edges)
{
  std::size_t count = 0;
  std::vector<std::uint32_t> half_edge = agreedHalfEdges(stars, count);
  std::vector<Triangle> triangles = agreedTriangles(stars, half_edge, count);
  const std::vector<Candidate> disputed = disputedTriangles(points, stars, half_edge);
  std::vector<std::uint32_t>().swap(stars.spokes); // not beside the opposites
  std::vector<std::uint32_t> opposite = agreedOpposites(stars, half_edge, count), outgoing_begin;
  compact(stars, half_edge, outgoing_begin);
  Triangulation mesh(std::move(triangles), std::move(opposite), std::move(outgoing_begin), std::move(half_edge));
  mesh.append(settle(disputed, mesh));
  mesh.append(pinholeTriangles(points, mesh, pinhole_edges));
  return mesh;
}

} // namespace pcl_spiral
