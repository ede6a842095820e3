// SPDX-License-Identifier: BSD-3-Clause
#include "outline_cut.h"

#include "handle_loop.h"
#include "narrow_strip.h"

#include <pcl_spiral/core/diagnostic.h>

#include <array>
#include <cstdint>

namespace pcl_spiral {
namespace {

using Triangle = Triangulation::Triangle;

constexpr double clear_of_rim = 0.45;         // spacings; points nearer to the outline are removed
constexpr double beside_rim = 3.0;            // spacings within which points are tested
constexpr double across_reach = 6.0;          // the same for triangles
constexpr double longest_noise_handle = 12.0; // spacings round; longer handles belong to the part
constexpr double across_depth = 0.15;         // spacings a triangle may reach beyond an outline

/** Places on the sides of a triangle, by the weights of its corners. */
constexpr std::array<std::array<double, 3>, 9> side_places{{{0.5, 0.5, 0.0},
                                                            {0.0, 0.5, 0.5},
                                                            {0.5, 0.0, 0.5},
                                                            {0.25, 0.75, 0.0},
                                                            {0.75, 0.25, 0.0},
                                                            {0.0, 0.25, 0.75},
                                                            {0.0, 0.75, 0.25},
                                                            {0.25, 0.0, 0.75},
                                                            {0.75, 0.0, 0.25}}};

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

/** The nodes and triangles to remove. */
struct Cut {
  std::vector<std::uint8_t> dead;   ///< one a node
  std::vector<std::uint8_t> across; ///< one a triangle

  bool keeps(const Triangulation& triangles, std::size_t i) const
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

Triangulation
largestPart(const Triangulation& triangles, const Cut& cut, std::size_t nodes)
{
  std::vector<Triangle> kept;
  kept.reserve(triangles.triangleCount());
  for (std::size_t i = 0; i < triangles.triangleCount(); ++i)
    if (cut.keeps(triangles, i))
      kept.push_back(triangles.triangle(i));
  Triangulation whole(nodes, std::move(kept));
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = whole.parts(sizes);
  if (sizes.size() < 2)
    return whole;
  kept = std::move(whole).release();
  std::size_t count = 0;
  for (std::size_t t = 0; t < kept.size(); ++t)
    if (part[t] == 0)
      kept[count++] = kept[t];
  kept.resize(count);
  return Triangulation(nodes, std::move(kept));
}

/** How many fans the triangles about \p v form: 1 on a sheet. */
std::size_t
fansAt(const Triangulation& triangles, std::uint32_t v)
{
  const std::size_t first = triangles.outgoingBegin(v), count = triangles.outgoingBegin(v + 1) - first;
  std::size_t free = 0, passed = 0;
  for (std::size_t o = first; o < first + count; ++o)
    free += triangles.opposite(triangles.outgoing(o)) == Triangulation::none;
  if (free > 0 || count == 0)
    return free;
  std::uint32_t h = triangles.outgoing(first);
  do {
    h = triangles.opposite(Triangulation::previous(h));
    ++passed;
  } while (h != Triangulation::none && h != triangles.outgoing(first));
  return passed == count ? 1 : 2;
}

/** Mark as dead the nodes at which free edges touch, or at which triangles touch only at that node. \return whether there were
 *  any. */
bool
dropPinches(const Triangulation& rest, std::vector<std::uint8_t>& dead)
{
  bool pinched = false;
  const auto count = static_cast<std::int64_t>(dead.size());
#pragma omp parallel for schedule(static, 4096) reduction(|| : pinched)
  for (std::int64_t v = 0; v < count; ++v)
    if (fansAt(rest, static_cast<std::uint32_t>(v)) > 1) {
      dead[v] = 1;
      pinched = true;
    }
  return pinched;
}

/** Mark as dead the nodes of a way round a handle, if it is short enough to come from noise. */
Status
dropHandle(const StepOverMesh& mesh, const Triangulation& rest, double spacing, std::vector<std::uint8_t>& dead, bool& dropped)
{
  dropped = false;
  if (missingEuler(mesh.positions, rest) == 0)
    return Status::success();
  const std::vector<std::uint32_t> way = handleLoop(mesh.positions, rest);
  Polyline points;
  for (const std::uint32_t v : way)
    points.push_back(mesh.positions[v]);
  if (way.empty() || length(points, true) > longest_noise_handle * spacing)
    return {StatusCode::Failed,
            Diagnostic("the surface has a handle at ", Place(points.empty() ? mesh.positions.front() : points.front()), ", ",
                       points.empty() ? 0.0 : length(points, true),
                       " {mm} round: a path at constant scallop needs a sheet with only a rim and holes; ", keepOutText(points, spacing),
                       "if the {scan} holds more than the part, such as the table below it, crop it to the part ({setCrop}), "
                       "or cut the part into pieces")};
  for (const std::uint32_t v : way)
    dead[v] = 1;
  dropped = true;
  return Status::success();
}

} // namespace

Status
trianglesWithin(const StepOverMesh& mesh, const Triangulation& triangles, const OutlineSide& side, double spacing, Triangulation& kept)
{
  Cut cut = cutAt(mesh, triangles, side, spacing);
  bool dropped = true;
  while (dropped) {
    do
      kept = largestPart(triangles, cut, mesh.size());
    while (dropPinches(kept, cut.dead));
    if (const Status status = dropHandle(mesh, kept, spacing, cut.dead, dropped); !status.ok())
      return status;
  }
  return Status::success();
}

} // namespace pcl_spiral
