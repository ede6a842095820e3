// SPDX-License-Identifier: BSD-3-Clause
#include "depth_map.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double cell = 2.0; ///< pixels
constexpr int columns = Canvas::width / 2, rows = Canvas::height / 2;

double
twiceArea(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector2d& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

} // namespace

DepthMap::DepthMap(const DisplaySurface& surface, const Canvas& canvas)
: canvas_(canvas), clearance_(clearance(surface)), depth_(static_cast<std::size_t>(columns) * rows, std::numeric_limits<float>::lowest())
{
  const Eigen::Vector3d towards = canvas.projection().towards();
  std::vector<Eigen::Vector3d> places; // cells to the right and up, mm towards the viewer
  for (vtkIdType i = 0; i < surface.mesh->GetNumberOfPoints(); ++i) {
    const Eigen::Map<const Eigen::Vector3d> p(surface.mesh->GetPoint(i));
    const Eigen::Vector2d at = canvas.onScreen(p) / cell;
    places.emplace_back(at.x(), at.y(), towards.dot(p));
  }
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < surface.mesh->GetNumberOfPolys(); ++t) {
    surface.mesh->GetPolys()->GetCellAtId(t, corners);
    addTriangle({places[corners->GetId(0)], places[corners->GetId(1)], places[corners->GetId(2)]});
  }
}

void
DepthMap::addTriangle(const std::array<Eigen::Vector3d, 3>& p)
{
  const double area = twiceArea(p[0], p[1], p[2].head<2>());
  if (area == 0.0)
    return;
  const Eigen::Vector3d low = p[0].cwiseMin(p[1]).cwiseMin(p[2]), high = p[0].cwiseMax(p[1]).cwiseMax(p[2]);
  const int first_x = std::max(0, static_cast<int>(std::ceil(low.x() - 0.5))),
            last_x = std::min(columns - 1, static_cast<int>(std::floor(high.x() - 0.5))),
            first_y = std::max(0, static_cast<int>(std::ceil(low.y() - 0.5))),
            last_y = std::min(rows - 1, static_cast<int>(std::floor(high.y() - 0.5)));
  for (int y = first_y; y <= last_y; ++y)
    for (int x = first_x; x <= last_x; ++x) {
      const Eigen::Vector2d middle(x + 0.5, y + 0.5);
      const double a = twiceArea(p[1], p[2], middle) / area, b = twiceArea(p[2], p[0], middle) / area, c = 1.0 - a - b;
      if (a < 0.0 || b < 0.0 || c < 0.0)
        continue;
      float& depth = depth_[static_cast<std::size_t>(y) * columns + x];
      depth = std::max(depth, static_cast<float>(a * p[0].z() + b * p[1].z() + c * p[2].z()));
    }
}

bool
DepthMap::hides(const Eigen::Vector3d& place) const
{
  const Eigen::Vector2d at = canvas_.onScreen(place) / cell;
  if (!(at.x() >= 0.0 && at.x() < columns && at.y() >= 0.0 && at.y() < rows))
    return true; // outside the picture
  const double depth = depth_[static_cast<std::size_t>(at.y()) * columns + static_cast<std::size_t>(at.x())];
  return depth > canvas_.projection().towards().dot(place) + clearance_;
}

} // namespace pcl_spiral
