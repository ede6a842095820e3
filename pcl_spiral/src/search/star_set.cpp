#include "star_set.h"

#include <algorithm>
#include <unordered_set>

namespace pcl_spiral {
namespace {

using Triangle = Triangulation::Triangle;

struct Candidate {
  Triangle corners;
  int votes;
};

std::uint64_t
halfEdge(std::uint32_t from, std::uint32_t to)
{
  return static_cast<std::uint64_t>(from) << 32 | to;
}

/** Triangles that start at their smallest corner among those whose stars have them, with the number of such corners. */
void
collect(const StarSet& stars, std::uint32_t v, std::vector<Triangle>& agreed, std::vector<Candidate>& disputed)
{
  const std::uint32_t first = stars.begin[v], last = stars.begin[v + 1];
  for (std::uint32_t s = first; s < last; ++s) {
    if (!(stars.spokes[s] & StarSet::triangle_flag))
      continue;
    const std::uint32_t a = StarSet::neighbour(stars.spokes[s]);
    const std::uint32_t b = StarSet::neighbour(stars.spokes[s + 1 == last ? first : s + 1]);
    const bool in_a = stars.hasTriangle(a, b, v), in_b = stars.hasTriangle(b, v, a);
    if ((in_a && a < v) || (in_b && b < v))
      continue;
    if (in_a && in_b)
      agreed.push_back({v, a, b});
    else
      disputed.push_back({{v, a, b}, 1 + in_a + in_b});
  }
}

/** Triangles for the short closed loops of free half-edges that disagreement leaves behind. */
std::vector<Triangle>
closePinholes(std::size_t points, const std::vector<Triangle>& triangles, int pinhole_edges)
{
  const Triangulation mesh(points, triangles);
  std::vector<Triangle> added;
  for (const auto& loop : mesh.boundaryLoops()) {
    const int m = static_cast<int>(loop.size());
    if (m < 3 || m > pinhole_edges)
      continue;
    // The hole lies on the right of the loop's half-edges: go round it backwards, as a fan about its first point.
    for (int i = 1; i + 1 < m; ++i)
      added.push_back({mesh.origin(loop[0]), mesh.origin(loop[i + 1]), mesh.origin(loop[i])});
  }
  return added;
}

} // namespace

void
StarSet::reverse(std::size_t i)
{
  const std::uint32_t first = begin[i], count = begin[i + 1] - first;
  std::vector<std::uint32_t> turned(count);
  for (std::uint32_t s = 0; s < count; ++s) {
    const std::uint32_t mirrored = count - 1 - s;
    const std::uint32_t before = (mirrored + count - 1) % count; // the spoke that comes next once turned round
    turned[s] = neighbour(spokes[first + mirrored]) | (spokes[first + before] & triangle_flag);
  }
  std::copy(turned.begin(), turned.end(), spokes.begin() + first);
}

bool
StarSet::hasTriangle(std::uint32_t v, std::uint32_t a, std::uint32_t b) const
{
  const std::uint32_t first = begin[v], last = begin[v + 1];
  for (std::uint32_t s = first; s < last; ++s)
    if (neighbour(spokes[s]) == a)
      return (spokes[s] & triangle_flag) && neighbour(spokes[s + 1 == last ? first : s + 1]) == b;
  return false;
}

std::vector<Triangle>
StarSet::agreedTriangles(int pinhole_edges) const
{
  const auto points = static_cast<std::int64_t>(begin.size()) - 1;
  constexpr std::int64_t chunk = 4096;
  const std::int64_t chunks = (points + chunk - 1) / chunk;
  std::vector<std::vector<Triangle>> agreed(chunks);
  std::vector<std::vector<Candidate>> disputed(chunks);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t c = 0; c < chunks; ++c)
    for (std::int64_t v = c * chunk; v < std::min(points, (c + 1) * chunk); ++v)
      collect(*this, static_cast<std::uint32_t>(v), agreed[c], disputed[c]);

  std::vector<Triangle> triangles;
  std::vector<Candidate> candidates;
  for (std::int64_t c = 0; c < chunks; ++c) {
    triangles.insert(triangles.end(), agreed[c].begin(), agreed[c].end());
    candidates.insert(candidates.end(), disputed[c].begin(), disputed[c].end());
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.votes > b.votes; });

  std::unordered_set<std::uint64_t> taken;
  // A half-edge (v, a) of a triangle all agree on is the one the star of v has after spoke a.
  const auto isFree = [&](std::uint32_t from, std::uint32_t to) {
    if (taken.count(halfEdge(from, to)))
      return false;
    const std::uint32_t first = begin[from], last = begin[from + 1];
    for (std::uint32_t s = first; s < last; ++s)
      if (neighbour(spokes[s]) == to && (spokes[s] & triangle_flag)) {
        const std::uint32_t third = neighbour(spokes[s + 1 == last ? first : s + 1]);
        return !(hasTriangle(to, third, from) && hasTriangle(third, from, to));
      }
    return true;
  };
  for (const Candidate& candidate : candidates) {
    const Triangle& t = candidate.corners;
    if (!isFree(t[0], t[1]) || !isFree(t[1], t[2]) || !isFree(t[2], t[0]))
      continue;
    for (int i = 0; i < 3; ++i)
      taken.insert(halfEdge(t[i], t[(i + 1) % 3]));
    triangles.push_back(t);
  }
  const std::vector<Triangle> fill = closePinholes(points, triangles, pinhole_edges);
  triangles.insert(triangles.end(), fill.begin(), fill.end());
  return triangles;
}

} // namespace pcl_spiral
