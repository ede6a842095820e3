// SPDX-License-Identifier: BSD-3-Clause
#include "section_lines.h"

#include <pcl_spiral/core/impl/frame.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <limits>
#include <numeric>

namespace pcl_spiral {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using BoxCorner = bg::model::point<double, 3, bg::cs::cartesian>;
using FaceBox = bg::model::box<BoxCorner>;
using FaceTree = bgi::rtree<std::pair<FaceBox, std::uint32_t>, bgi::rstar<16>>;

/** Boxes in the frame of the planes, where queries are flat boxes. */
FaceTree
faceTree(const SurfaceMesh& mesh, const Eigen::Vector3d& normal, const std::vector<double>& distances)
{
  Eigen::Vector3d e1, e2;
  tangentFrame(normal, e1, e2);
  std::vector<std::pair<FaceBox, std::uint32_t>> boxes(mesh.faceCount());
#pragma omp parallel for schedule(static)
  for (std::int64_t t = 0; t < static_cast<std::int64_t>(boxes.size()); ++t) {
    Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const std::uint32_t v : mesh.triangles().triangle(t)) {
      const Eigen::Vector3d x(e1.dot(mesh.position(v)), e2.dot(mesh.position(v)), distances[v]);
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    boxes[t] = {{{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}, static_cast<std::uint32_t>(t)};
  }
  return FaceTree(boxes);
}

std::vector<std::uint32_t>
facesAt(const FaceTree& tree, double level)
{
  constexpr double far = std::numeric_limits<double>::max();
  std::vector<std::uint32_t> faces;
  const FaceBox plane({-far, -far, level}, {far, far, level});
  for (auto it = tree.qbegin(bgi::intersects(plane)); it != tree.qend(); ++it)
    faces.push_back(it->second);
  std::sort(faces.begin(), faces.end());
  return faces;
}

} // namespace

std::vector<std::vector<LevelLine>>
sectionLines(const SurfaceMesh& mesh, const Eigen::Vector3d& normal, const std::vector<double>& distances,
             const std::vector<double>& levels, MeshSearch search)
{
  if (search == MeshSearch::LevelLines)
    return levelLines(mesh.triangles(), distances, levels);
  const FaceTree tree = search == MeshSearch::RTree ? faceTree(mesh, normal, distances) : FaceTree();
  std::vector<std::uint32_t> all(search == MeshSearch::AllFaces ? mesh.faceCount() : 0);
  std::iota(all.begin(), all.end(), 0u);
  std::vector<std::vector<LevelLine>> lines(levels.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(levels.size()); ++k)
    lines[k] = levelLines(mesh.triangles(), distances, levels[k], search == MeshSearch::RTree ? facesAt(tree, levels[k]) : all);
  return lines;
}

} // namespace pcl_spiral
