// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/graph/impl/surface_parts.h>

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

/** Call \p visit(part, point) for the corners of all triangles. */
template <typename Visit>
void
forCorners(const SurfaceGraph& graph, const SurfaceParts& parts, Visit visit)
{
  const Triangulation& mesh = graph.triangulation();
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
    for (const std::uint32_t v : mesh.triangle(t))
      visit(parts.of_triangle[t], graph.position(v));
}

/** Set place and box of all parts. */
void
addPlaces(const SurfaceGraph& graph, SurfaceParts& parts)
{
  std::vector<double> nearest(parts.parts.size(), std::numeric_limits<double>::max());
  forCorners(graph, parts, [&](std::uint32_t p, const Eigen::Vector3d& corner) {
    SurfacePart& part = parts.parts[p];
    part.box.extend(corner);
    if (const double off = (corner - part.centre).squaredNorm(); off < nearest[p]) {
      nearest[p] = off;
      part.place = corner;
    }
  });
}

} // namespace

SurfaceParts
surfaceParts(const SurfaceGraph& graph)
{
  const Triangulation& mesh = graph.triangulation();
  SurfaceParts result;
  std::vector<std::size_t> sizes;
  result.of_triangle = mesh.parts(sizes);
  result.parts.resize(sizes.size());
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto corners = mesh.triangle(t);
    const Eigen::Vector3d a = graph.position(corners[0]), b = graph.position(corners[1]), c = graph.position(corners[2]);
    const double area = 0.5 * (b - a).cross(c - a).norm();
    SurfacePart& part = result.parts[result.of_triangle[t]];
    ++part.triangles;
    part.area += area;
    part.centre += area / 3.0 * (a + b + c);
  }
  for (SurfacePart& part : result.parts)
    if (part.area > 0.0)
      part.centre /= part.area;
  addPlaces(graph, result);
  return result;
}

std::size_t
nearestPart(const SurfaceGraph& graph, const SurfaceParts& parts, const Eigen::Vector3d& place, double& distance)
{
  std::size_t nearest = 0;
  distance = std::numeric_limits<double>::max();
  forCorners(graph, parts, [&](std::uint32_t p, const Eigen::Vector3d& corner) {
    if (const double off = (corner - place).norm(); off < distance) {
      distance = off;
      nearest = p;
    }
  });
  return nearest;
}

bool
isCluster(const SurfacePart& part, const SurfacePart& first, std::size_t all_triangles, double share)
{
  return static_cast<double>(part.triangles) <= share * static_cast<double>(all_triangles) && part.area <= 2.0 * first.area;
}

OtherParts
otherParts(const std::vector<SurfacePart>& parts, double share)
{
  constexpr double clusters_together = 10.0; // of the largest one
  if (parts.size() < 2)
    return OtherParts::None;
  std::size_t all = 0;
  for (const SurfacePart& part : parts)
    all += part.triangles;
  for (std::size_t i = 1; i < parts.size(); ++i)
    if (!isCluster(parts[i], parts[0], all, share))
      return OtherParts::TooLarge;
  const auto left_out = static_cast<double>(all - parts[0].triangles);
  return left_out > clusters_together * share * static_cast<double>(all) ? OtherParts::TooMany : OtherParts::Clusters;
}

Diagnostic
partsText(const std::vector<SurfacePart>& parts, bool to_choose)
{
  constexpr std::size_t most_named = 6;
  std::vector<SurfacePart> by_area = parts;
  std::stable_sort(by_area.begin(), by_area.end(), [](const SurfacePart& a, const SurfacePart& b) { return a.area > b.area; });
  Diagnostic list;
  for (std::size_t i = 0; i < std::min(parts.size(), most_named); ++i)
    list += Diagnostic(i > 0 ? ", " : "", by_area[i].area, " {mm2} at ",
                       to_choose ? Diagnostic(Proposed("setPartAt", by_area[i].place)) : Diagnostic(Place(by_area[i].place)));
  if (parts.size() > most_named)
    list += Diagnostic(" and ", parts.size() - most_named, " more");
  return list;
}

PartDistance
nearestOther(const SurfaceGraph& graph, const SurfaceParts& parts, std::size_t part)
{
  const std::vector<std::uint8_t> others = apartFrom(graph, parts, part);
  std::vector<Eigen::Vector3f> of_part, of_others;
  const Triangulation& mesh = graph.triangulation();
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    if (mesh.outgoingBegin(v) < mesh.outgoingBegin(v + 1))
      (others[v] ? of_others : of_part).push_back(graph.blocks().point(v));
  const PointBlocks blocks(std::move(of_others));
  PartDistance nearest;
  float least = std::numeric_limits<float>::max();
  for (const Eigen::Vector3f& p : of_part)
    blocks.forBlocks([&](const Box& box) { return box.squaredDistance(p.data()) < least; },
                     [&](std::size_t block) {
                       for (std::size_t i = blocks.blockBegin(block); i < blocks.blockEnd(block); ++i)
                         if (const float squared = (blocks.point(i) - p).squaredNorm(); squared < least) {
                           least = squared;
                           nearest = {std::sqrt(squared), (0.5f * (blocks.point(i) + p)).cast<double>()};
                         }
                     });
  return nearest;
}

Diagnostic
severalPartsText(const SurfaceGraph& graph, const SurfaceParts& parts)
{
  const auto smaller = [](const SurfacePart& a, const SurfacePart& b) { return a.area < b.area; };
  const auto largest = std::max_element(parts.parts.begin(), parts.parts.end(), smaller);
  const PartDistance apart = nearestOther(graph, parts, static_cast<std::size_t>(largest - parts.parts.begin()));
  return Diagnostic("the {cloud} has ", parts.parts.size(), " separate parts: ", partsText(parts.parts), "; the largest is ",
                    apart.distance, " {mm} from the next one, at ", Place(apart.middle),
                    ": if they are one surface, {scan what is between them}; keep only the largest one ({setLargestPart}), or only the one "
                    "to be machined, by a place on it ({setPartAt})");
}

std::vector<std::uint8_t>
apartFrom(const SurfaceGraph& graph, const SurfaceParts& parts, std::size_t part)
{
  const Triangulation& mesh = graph.triangulation();
  std::vector<std::uint8_t> apart(graph.size(), 0);
  for (const bool own : {false, true})
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
      if ((parts.of_triangle[t] == part) == own)
        for (const std::uint32_t v : mesh.triangle(t))
          apart[v] = own ? 0 : 1;
  return apart;
}

} // namespace pcl_spiral
