#include "star_triangles.h"

#include "pieces.h"

#include <algorithm>
#include <unordered_set>

namespace pcl_spiral {
namespace {

using Triangle = Triangulation::Triangle;
constexpr std::uint32_t none = Triangulation::none;

/** The number of the triangle all agree on at each slot, none where they do not. Triangles are numbered by their smallest
 *  corner, so that those of one place lie together. */
std::vector<std::uint32_t>
numberAgreed(const StarSet& stars, std::size_t& count)
{
  std::vector<std::uint32_t> number(stars.spokes.size(), none);
  std::vector<std::uint32_t> first(pieceCount(stars.size()) + 1, 0); // of each piece
  forPoints(stars.size(), [&](std::uint32_t v) {
    std::uint32_t& own = first[v / piece_size + 1];
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot) {
      const std::uint32_t a = stars.neighbourAt(slot), b = stars.neighbourAt(stars.slotAfter(v, slot));
      if (!stars.hasTriangle(slot) || a < v || b < v)
        continue;
      const std::uint32_t at_a = stars.slotOf(a, b, v), at_b = stars.slotOf(b, v, a);
      if (at_a != none && at_b != none)
        number[slot] = number[at_a] = number[at_b] = own++;
    }
  });
  for (std::size_t p = 1; p < first.size(); ++p)
    first[p] += first[p - 1];
  forPoints(stars.size(), [&](std::uint32_t v) {
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot)
      if (number[slot] != none)
        number[slot] += first[std::min({v, stars.neighbourAt(slot), stars.neighbourAt(stars.slotAfter(v, slot))}) / piece_size];
  });
  count = first.back();
  return number;
}

/** Which corner \p v is of the triangle (v, a, b), whose first is the smallest. */
std::uint32_t
cornerOf(std::uint32_t v, std::uint32_t a, std::uint32_t b)
{
  return v < a && v < b ? 0 : a < b ? 2 : 1;
}

/** The mesh of the triangles all agree on. Neighbours in a star are neighbours in the mesh. */
Triangulation
agreedMesh(const StarSet& stars, const std::vector<std::uint32_t>& number, std::size_t count)
{
  const std::size_t room = count + count / 64; // for those that come later
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> opposite, outgoing, outgoing_begin(stars.size() + 1, 0);
  triangles.reserve(room);
  triangles.resize(count);
  for (auto* array : {&opposite, &outgoing}) {
    array->reserve(3 * room);
    array->resize(3 * count, none);
  }
  forPoints(stars.size(), [&](std::uint32_t v) {
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot)
      outgoing_begin[v + 1] += number[slot] != none;
  });
  for (std::size_t v = 0; v < stars.size(); ++v)
    outgoing_begin[v + 1] += outgoing_begin[v];
  forPoints(stars.size(), [&](std::uint32_t v) {
    std::uint32_t out = outgoing_begin[v];
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot) {
      if (number[slot] == none)
        continue;
      const std::uint32_t a = stars.neighbourAt(slot), b = stars.neighbourAt(stars.slotAfter(v, slot));
      const std::uint32_t corner = cornerOf(v, a, b), half_edge = 3 * number[slot] + corner;
      if (corner == 0)
        triangles[number[slot]] = {v, a, b};
      outgoing[out++] = half_edge;
      const std::uint32_t before = stars.slotBefore(v, slot);
      if (number[before] != none) // (v, z, a): its half-edge a - v faces this one
        opposite[half_edge] = 3 * number[before] + (cornerOf(v, stars.neighbourAt(before), a) + 2) % 3;
    }
  });
  return Triangulation(std::move(triangles), std::move(opposite), std::move(outgoing_begin), std::move(outgoing));
}

struct Candidate {
  Triangle corners;
  int votes;
};

/** Triangles that not all agree on, each named by the smallest corner that has it; those with most votes first. */
std::vector<Candidate>
disputedTriangles(const StarSet& stars, const std::vector<std::uint32_t>& number)
{
  std::vector<std::vector<Candidate>> found(pieceCount(stars.size()));
  forPoints(stars.size(), [&](std::uint32_t v) {
    for (std::uint32_t slot = stars.begin[v]; slot < stars.begin[v + 1]; ++slot) {
      if (!stars.hasTriangle(slot) || number[slot] != none)
        continue;
      const std::uint32_t a = stars.neighbourAt(slot), b = stars.neighbourAt(stars.slotAfter(v, slot));
      const bool in_a = stars.slotOf(a, b, v) != none, in_b = stars.slotOf(b, v, a) != none;
      if (!(in_a && a < v) && !(in_b && b < v))
        found[v / piece_size].push_back({{v, a, b}, 1 + in_a + in_b});
    }
  });
  std::vector<Candidate> disputed;
  for (const auto& part : found)
    disputed.insert(disputed.end(), part.begin(), part.end());
  std::stable_sort(disputed.begin(), disputed.end(),
                   [](const Candidate& a, const Candidate& b) { return a.votes > b.votes; });
  return disputed;
}

/** Of the candidates, in their order, those whose half-edges are still free. */
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
  for (const auto& [t, votes] : candidates) {
    if (!isFree(t[0], t[1]) || !isFree(t[1], t[2]) || !isFree(t[2], t[0]))
      continue;
    for (int i = 0; i < 3; ++i)
      taken.insert(key(t[i], t[(i + 1) % 3]));
    accepted.push_back(t);
  }
  return accepted;
}

/** Triangles for the short closed loops of free half-edges that disagreement leaves behind. */
std::vector<Triangle>
pinholeTriangles(const Triangulation& mesh, int pinhole_edges)
{
  std::vector<Triangle> triangles;
  for (const auto& loop : mesh.boundaryLoops()) {
    const int m = static_cast<int>(loop.size());
    if (m < 3 || m > pinhole_edges)
      continue;
    // The hole lies on the right of the loop's half-edges: go round it backwards, as a fan about its first point.
    for (int i = 1; i + 1 < m; ++i)
      triangles.push_back({mesh.origin(loop[0]), mesh.origin(loop[i + 1]), mesh.origin(loop[i])});
  }
  return triangles;
}

} // namespace

Triangulation
triangulate(const StarSet& stars, int pinhole_edges)
{
  std::size_t count = 0;
  std::vector<std::uint32_t> number = numberAgreed(stars, count);
  Triangulation mesh = agreedMesh(stars, number, count);
  const std::vector<Candidate> disputed = disputedTriangles(stars, number);
  std::vector<std::uint32_t>().swap(number);
  mesh.append(settle(disputed, mesh));
  mesh.append(pinholeTriangles(mesh, pinhole_edges));
  return mesh;
}

} // namespace pcl_spiral
