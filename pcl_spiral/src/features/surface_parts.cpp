#include <pcl_spiral/features/surface_parts.h>

#include <pcl_spiral/common/message.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl_spiral {

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
  return result;
}

std::string
partsText(const std::vector<SurfacePart>& parts)
{
  constexpr std::size_t most_named = 4;
  std::string list;
  for (std::size_t i = 0; i < std::min(parts.size(), most_named); ++i)
    list += textOf(i > 0 ? ", " : "", parts[i].area, " mm2 about ", placeText(parts[i].centre));
  if (parts.size() > most_named)
    list += textOf(" and ", parts.size() - most_named, " more");
  return list;
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
