// SPDX-License-Identifier: BSD-3-Clause
#include "welded_faces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <numeric>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** One side of a face: its edge by the lower and the higher vertex, and the direction of the face along it. */
struct FaceSide {
  std::uint32_t low, high, face;
  bool rising;
};

std::vector<FaceSide>
sidesOf(const std::vector<Triangulation::Triangle>& faces)
{
  std::vector<FaceSide> sides;
  sides.reserve(3 * faces.size());
  for (std::uint32_t t = 0; t < faces.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = faces[t][k], b = faces[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const FaceSide& a, const FaceSide& b) {
    return std::array{a.low, a.high, a.face} < std::array{b.low, b.high, b.face};
  });
  return sides;
}

/** Calls visit(begin, end) with the sides of each edge. */
template <typename Visit>
void
forEdges(const std::vector<FaceSide>& sides, Visit visit)
{
  for (std::size_t begin = 0, end; begin < sides.size(); begin = end) {
    for (end = begin + 1; end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high;)
      ++end;
    visit(begin, end);
  }
}

/** Faces across edges of two, three per face at most, and whether they run the same way along the edge, so that one of them must
 *  be turned. */
struct FaceNeighbours {
  struct Neighbour {
    std::uint32_t face;
    bool opposed;
  };
  std::vector<std::array<Neighbour, 3>> of;
  std::vector<std::uint8_t> count;

  void join(std::uint32_t a, std::uint32_t b, bool opposed)
  {
    of[a][count[a]++] = {b, opposed};
    of[b][count[b]++] = {a, opposed};
  }
};

double
areaOf(const WeldedFaces& welded, std::uint32_t t)
{
  const auto& f = welded.faces[t];
  const Vector3d& a = welded.positions[f[0]];
  return 0.5 * (welded.positions[f[1]] - a).cross(welded.positions[f[2]] - a).norm();
}

/** The faces of the part of \p first, each with whether it faces the opposite way to that one. */
void
followPart(const FaceNeighbours& neighbours, std::uint32_t first, std::vector<std::uint8_t>& seen, std::vector<std::uint8_t>& turned,
           std::vector<std::uint32_t>& part)
{
  part.assign(1, first);
  seen[first] = 1;
  for (std::size_t k = 0; k < part.size(); ++k)
    for (int j = 0; j < neighbours.count[part[k]]; ++j) {
      const FaceNeighbours::Neighbour next = neighbours.of[part[k]][j];
      if (seen[next.face])
        continue;
      seen[next.face] = 1;
      turned[next.face] = turned[part[k]] ^ static_cast<std::uint8_t>(next.opposed);
      part.push_back(next.face);
    }
}

} // namespace

void
turnFaces(WeldedFaces& welded, MeshReport& counts)
{
  const std::size_t n = welded.faces.size();
  const std::vector<FaceSide> sides = sidesOf(welded.faces);
  FaceNeighbours neighbours{std::vector<std::array<FaceNeighbours::Neighbour, 3>>(n), std::vector<std::uint8_t>(n, 0)};
  const auto middle = [&](const FaceSide& side) { return Vector3d(0.5 * (welded.positions[side.low] + welded.positions[side.high])); };
  forEdges(sides, [&](std::size_t begin, std::size_t end) {
    if (end - begin == 2)
      neighbours.join(sides[begin].face, sides[begin + 1].face, sides[begin].rising == sides[begin + 1].rising);
    else if (end - begin > 2)
      counts.crowded_edges.add(middle(sides[begin]));
  });
  std::vector<std::uint8_t> seen(n, 0), turned(n, 0);
  std::vector<std::uint32_t> part;
  for (std::uint32_t first = 0; first < n; ++first) {
    if (seen[first])
      continue;
    followPart(neighbours, first, seen, turned, part);
    double whole = 0.0, opposed = 0.0;
    for (const std::uint32_t t : part) {
      whole += areaOf(welded, t);
      opposed += turned[t] ? areaOf(welded, t) : 0.0;
    }
    if (opposed > 0.5 * whole)
      for (const std::uint32_t t : part)
        turned[t] ^= 1;
  }
  for (std::uint32_t t = 0; t < n; ++t)
    if (turned[t]) {
      std::swap(welded.faces[t][1], welded.faces[t][2]);
      counts.turned.add(welded.positions[welded.faces[t][0]]);
    }
  forEdges(sides, [&](std::size_t begin, std::size_t end) {
    if (end - begin == 2 && (sides[begin].rising ^ turned[sides[begin].face]) == (sides[begin + 1].rising ^ turned[sides[begin + 1].face]))
      counts.one_sided_edges.add(middle(sides[begin]));
  });
}

} // namespace pcl_spiral
