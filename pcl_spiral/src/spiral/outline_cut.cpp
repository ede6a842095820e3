#include "outline_cut.h"

#include <array>
#include <cstdint>

namespace pcl_spiral {
namespace {

using Triangle = Triangulation::Triangle;

constexpr double clear_of_rim = 0.45; // spacings; nearer points give way to the outline
constexpr double beside_rim = 3.0;    // spacings within which points are looked at
constexpr double across_reach = 6.0;  // the same for triangles
constexpr double across_depth = 0.15; // spacings a triangle may reach beyond an outline

/** Places on the sides of a triangle, by the weights of its corners. */
constexpr std::array<std::array<double, 3>, 9> side_places{{{0.5, 0.5, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5},
                                                           {0.25, 0.75, 0.0}, {0.75, 0.25, 0.0}, {0.0, 0.25, 0.75},
                                                           {0.0, 0.75, 0.25}, {0.25, 0.0, 0.75}, {0.75, 0.0, 0.25}}};

bool
reachesAcross(const StepOverMesh& mesh, const Triangle& t, const OutlineSide& side, double spacing)
{
  for (const auto& w : side_places) {
    Eigen::Vector3d p = Eigen::Vector3d::Zero(), n = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      p += w[i] * mesh.positions[t[i]];
      n += w[i] * mesh.normals[t[i]].cast<double>();
    }
    OutlinePlace place;
    if (side.find(p, n.normalized(), across_reach * spacing, place) && !place.inside && place.distance > across_depth * spacing)
      return true;
  }
  return false;
}

/** Which nodes give way, and which triangles. */
struct Cut {
  std::vector<std::uint8_t> dead;   ///< one a node
  std::vector<std::uint8_t> across; ///< one a triangle

  bool
  keeps(const Triangulation& triangles, std::size_t i) const
  {
    const Triangle& t = triangles.triangle(i);
    return !across[i] && !dead[t[0]] && !dead[t[1]] && !dead[t[2]];
  }
};

Cut
cutAt(const StepOverMesh& mesh, const Triangulation& triangles, const OutlineSide& side, double spacing)
{
  Cut cut{std::vector<std::uint8_t>(mesh.size(), 0), std::vector<std::uint8_t>(triangles.triangleCount(), 0)};
  std::vector<std::uint8_t> near(mesh.size(), 0);
  const auto count = static_cast<std::int64_t>(mesh.size());
#pragma omp parallel for schedule(dynamic, 4096)
  for (std::int64_t i = 0; i < count; ++i) {
    OutlinePlace place;
    if (!side.find(mesh.positions[i], mesh.normals[i].cast<double>(), across_reach * spacing, place))
      continue;
    near[i] = 1;
    cut.dead[i] = place.distance < beside_rim * spacing && (!place.inside || place.distance < clear_of_rim * spacing);
  }
  const auto triangle_count = static_cast<std::int64_t>(triangles.triangleCount());
#pragma omp parallel for schedule(dynamic, 4096)
  for (std::int64_t i = 0; i < triangle_count; ++i) {
    const Triangle& t = triangles.triangle(i);
    cut.across[i] = cut.keeps(triangles, i) && (near[t[0]] || near[t[1]] || near[t[2]]) && reachesAcross(mesh, t, side, spacing);
  }
  return cut;
}

std::vector<Triangle>
largestPart(const Triangulation& triangles, const Cut& cut, std::size_t nodes)
{
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < triangles.triangleCount(); ++i)
    if (cut.keeps(triangles, i))
      kept.push_back(triangles.triangle(i));
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = Triangulation(nodes, kept).parts(sizes);
  std::size_t count = 0;
  for (std::size_t t = 0; t < kept.size(); ++t)
    if (part[t] == 0)
      kept[count++] = kept[t];
  kept.resize(count);
  return kept;
}

/** Nodes at which free edges touch are dead from now on. \return whether there were any. */
bool
dropPinches(const std::vector<Triangle>& triangles, std::vector<std::uint8_t>& dead)
{
  const Triangulation rest(dead.size(), triangles);
  std::vector<std::uint8_t> ends(dead.size(), 0);
  bool pinched = false;
  for (std::uint32_t h = 0; h < rest.halfEdgeCount(); ++h)
    if (rest.opposite(h) == Triangulation::none && ++ends[rest.origin(h)] > 1) {
      dead[rest.origin(h)] = 1;
      pinched = true;
    }
  return pinched;
}

} // namespace

std::vector<Triangle>
trianglesWithin(const StepOverMesh& mesh, const Triangulation& triangles, const OutlineSide& side, double spacing)
{
  Cut cut = cutAt(mesh, triangles, side, spacing);
  std::vector<Triangle> kept;
  do
    kept = largestPart(triangles, cut, mesh.size());
  while (dropPinches(kept, cut.dead));
  return kept;
}

} // namespace pcl_spiral
