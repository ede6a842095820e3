// SPDX-License-Identifier: BSD-3-Clause
#include "planning/uncut_strips.h"

#include "surface/narrow_strips.h"
#include <pcl_spiral/cleaning/impl/point_groups.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

/** A third of the area of the triangles at point \p v of \p surface, mm2. */
double
areaAt(const Surface& surface, std::uint32_t v)
{
  const Triangulation& mesh = surface.graph().triangulation();
  double area = 0.0;
  for (std::size_t o = mesh.outgoingBegin(v); o < mesh.outgoingBegin(v + 1); ++o) {
    const Triangulation::Triangle t = mesh.triangle(mesh.outgoing(o) / 3);
    const Eigen::Vector3d a = surface.position(t[0]);
    area += (surface.position(t[1]) - a).cross(surface.position(t[2]) - a).norm() / 6.0;
  }
  return area;
}

/** The point of \p strip that is nearest to its mean. */
Eigen::Vector3d
middleOf(const UncutStrip& strip)
{
  Eigen::Vector3f mean = Eigen::Vector3f::Zero();
  for (const Eigen::Vector3f& p : strip.points)
    mean += p / static_cast<float>(strip.points.size());
  const auto nearer = [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return (a - mean).norm() < (b - mean).norm(); };
  return std::min_element(strip.points.begin(), strip.points.end(), nearer)->cast<double>();
}

} // namespace

std::vector<UncutStrip>
stripsBeside(const Surface& surface, const pcl::PointCloud<pcl::PointXYZ>& cloud, const pcl::Indices& kept, double width)
{
  constexpr double link = 3.0; // spacings between points of one strip
  std::vector<std::uint8_t> is_kept(cloud.size(), 0), of_surface(surface.size());
  for (const auto i : kept)
    is_kept[static_cast<std::size_t>(i)] = 1;
  for (std::size_t i = 0; i < surface.size(); ++i)
    of_surface[i] = is_kept[surface.sourceIndex(i)];
  const std::vector<std::uint8_t> narrow = narrowStrips(surface.graph(), of_surface, width * surface.spacing());
  pcl::Indices found;
  std::vector<Eigen::Vector3f> points;
  if (std::find(narrow.begin(), narrow.end(), 1) != narrow.end())
    for (const auto i : kept) {
      const Eigen::Vector3f p = cloud[static_cast<std::size_t>(i)].getVector3fMap();
      if (narrow[surface.graph().blocks().nearest(p.cast<double>())] == 0)
        continue;
      found.push_back(i);
      points.push_back(p);
    }
  std::vector<UncutStrip> strips;
  const std::vector<std::uint32_t> group = pointGroups(points, link * surface.spacing());
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (group[i] == strips.size())
      strips.emplace_back();
    strips[group[i]].indices.push_back(found[i]);
    strips[group[i]].points.push_back(points[i]);
  }
  std::vector<std::uint32_t> of_cloud(cloud.size(), Triangulation::none); // index on the surface
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    of_cloud[surface.sourceIndex(i)] = i;
  for (UncutStrip& strip : strips) {
    strip.width = width * surface.spacing();
    strip.place = middleOf(strip);
    for (const auto i : strip.indices)
      if (const std::uint32_t v = of_cloud[static_cast<std::size_t>(i)]; v != Triangulation::none)
        strip.area += areaAt(surface, v);
  }
  return strips;
}

Diagnostic
stripText(const UncutStrip& strip)
{
  return Diagnostic("a strip between a keep-out and the rim is not cut: ", strip.area, " {mm2} at ", Place(strip.place), ", narrower than ",
                    strip.width,
                    " {mm}; no path was found with it, because its points are too few: scan it more densely, or cut it with the "
                    "keep-out elsewhere");
}

} // namespace pcl_spiral
