// SPDX-License-Identifier: BSD-3-Clause
#include "verification_map.h"

#include "path_layer.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double line_radius = 1.0,
                 least_pitch = 8.0;                                 ///< pixels; turns nearer to each other fill the surface
constexpr double pitch_share = 0.6;                                 ///< of the pitch, for a disc that reaches the disc of the next turn
constexpr double inset_line_radius = 2.0, outstanding_radius = 3.0; ///< pixels
constexpr double least_inset_disc = 2.0, most_inset_disc = 9.0;     ///< pixels
constexpr double disc_of_spacing = 0.9;                             ///< discs of this radius leave no gaps between neighbours
constexpr double least_inset = 0.001, most_inset = 0.3;             ///< of the part's size
constexpr double inset_depth = 0.3; ///< of its width: anything farther from its plane is another side of the part
constexpr Color path_color{0.05, 0.05, 0.08};

/** Puts moves on cells; \p at gives the place of a point in the view, \p shown whether it is visible. */
template <typename At, typename Shown>
void
putPath(WorstCells& cells, const pcl::PointCloud<ToolpathPoint>& path, const std::vector<float>& values, const ValueStyle& style,
        double radius, const At& at, const Shown& shown)
{
  bool before = false;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d place = path[i].getVector3fMap().cast<double>();
    const bool now = place.allFinite() && shown(place);
    const Eigen::Vector2d to = now ? at(place) : Eigen::Vector2d::Zero();
    const int steps = now && before ? std::max(1, static_cast<int>(std::ceil((to - from).norm()))) : 1;
    for (int k = now && before ? 0 : 1; now && k <= steps; ++k) {
      const double t = static_cast<double>(k) / steps;
      const float value = values[t < 0.5 ? i - 1 : i];
      cells.put((1.0 - t) * from + t * to, radius, value, style.rank(value));
    }
    if (now && style.outstanding(values[i]))
      cells.put(to, std::max(radius, outstanding_radius), values[i], style.rank(values[i]));
    before = now;
    from = to;
  }
}

template <typename At, typename Shown>
void
putPoints(WorstCells& cells, const pcl::PointCloud<pcl::PointXYZ>& points, const std::vector<float>& values, const ValueStyle& style,
          double radius, const At& at, const Shown& shown)
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d place = points[i].getVector3fMap().cast<double>();
    if (!std::isnan(values[i]) && place.allFinite() && shown(place))
      cells.put(at(place), style.outstanding(values[i]) ? std::max(radius, outstanding_radius) : radius, values[i], style.rank(values[i]));
  }
}

auto
near(const WorstPlace& worst, double move = 0.0)
{
  return [worst, reach = worst.across + move](const Eigen::Vector3d& place) {
    const Eigen::Vector3d off = place - worst.position;
    return off.norm() < reach && std::abs(off.dot(worst.normal)) < inset_depth * reach;
  };
}

/** The enlarged view with its surface, circle and caption, drawn after \p fill. */
template <typename Fill>
void
addInset(Canvas& canvas, int slot, const DisplaySurface& surface, const WorstPlace& worst, const Fill& fill)
{
  const Inset inset = canvas.addInset(slot, worst.position, worst.normal, worst.across);
  inset.view->AddActor(surfaceActor(surfaceNear(surface, worst.position, worst.across), surface_color));
  fill(inset);
  addMark(inset.view, Marker::Circle, Eigen::Vector2d::Constant(0.5 * Canvas::inset_size), ink);
  addText(inset.view, worst.caption + formatted(", %.3g mm across", worst.across), 10, 10, 18, true);
}

double
areaOf(const DisplaySurface& surface)
{
  double area = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < surface.mesh->GetNumberOfPolys(); ++t) {
    surface.mesh->GetPolys()->GetCellAtId(t, corners);
    Eigen::Vector3d p[3];
    for (int i = 0; i < 3; ++i)
      p[i] = Eigen::Map<const Eigen::Vector3d>(surface.mesh->GetPoint(corners->GetId(i)));
    area += 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
  }
  return area;
}

} // namespace

void
addPathMap(Canvas& canvas, const DepthMap& depth, const DisplaySurface& surface, const pcl::PointCloud<ToolpathPoint>& path,
           const std::vector<float>& values, const ValueStyle& style)
{
  const double pitch = insetWidth(surface, path) / inset_pitches / canvas.projection().mm_per_pixel;
  WorstCells cells(Canvas::width, Canvas::height);
  putPath(
      cells, path, values, style, pitch < least_pitch ? std::max(line_radius, pitch_share * pitch) : line_radius,
      [&](const Eigen::Vector3d& p) { return canvas.onScreen(p); }, [&](const Eigen::Vector3d& p) { return !depth.hides(p); });
  cells.addTo(canvas.view(), style.color);
}

void
addPathInset(Canvas& canvas, int slot, const DisplaySurface& surface, const WorstPlace& worst, const pcl::PointCloud<ToolpathPoint>& path,
             const std::vector<float>& values, const ValueStyle& style)
{
  addInset(canvas, slot, surface, worst, [&](const Inset& inset) {
    WorstCells cells(Canvas::inset_size, Canvas::inset_size);
    putPath(
        cells, path, values, style, inset_line_radius, [&](const Eigen::Vector3d& p) { return inset.onScreen(p); },
        near(worst, longestMove(path)));
    cells.addTo(inset.view, style.color);
  });
}

void
addPointMap(Canvas& canvas, const DepthMap& depth, const pcl::PointCloud<pcl::PointXYZ>& points, const std::vector<float>& values,
            double radius, const ValueStyle& style)
{
  WorstCells cells(Canvas::width, Canvas::height);
  putPoints(
      cells, points, values, style, radius, [&](const Eigen::Vector3d& p) { return canvas.onScreen(p); },
      [&](const Eigen::Vector3d& p) { return !depth.hides(p); });
  cells.addTo(canvas.view(), style.color);
}

void
addPointInset(Canvas& canvas, int slot, const DisplaySurface& surface, const WorstPlace& worst,
              const pcl::PointCloud<pcl::PointXYZ>& points, const std::vector<float>& values, double radius, const ValueStyle& style,
              const pcl::PointCloud<ToolpathPoint>& path)
{
  addInset(canvas, slot, surface, worst, [&](const Inset& inset) {
    const auto at = [&](const Eigen::Vector3d& p) { return inset.onScreen(p); };
    WorstCells cells(Canvas::inset_size, Canvas::inset_size), lines = cells;
    putPoints(cells, points, values, style, std::clamp(radius / inset.projection.mm_per_pixel, least_inset_disc, most_inset_disc), at,
              near(worst));
    cells.addTo(inset.view, style.color);
    const ValueStyle plain{[](float) { return 0.0f; }, [](float) { return path_color; }, [](float) { return false; }};
    putPath(lines, path, std::vector<float>(path.size(), 0.0f), plain, 0.0, at, near(worst, longestMove(path)));
    lines.addTo(inset.view, plain.color);
  });
}

double
discRadius(const DisplaySurface& surface, std::size_t points)
{
  if (surface.of_mesh)
    return disc_of_spacing * surface.spacing;
  const double drawn = static_cast<double>(std::max<vtkIdType>(surface.mesh->GetNumberOfPoints(), 1));
  return disc_of_spacing * surface.spacing * std::sqrt(drawn / std::max(static_cast<double>(points), drawn));
}

double
insetWidth(const DisplaySurface& surface, const pcl::PointCloud<ToolpathPoint>& path)
{
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += (path[i].getVector3fMap() - path[i - 1].getVector3fMap()).norm();
  const double size = (surface.high - surface.low).norm();
  return std::clamp(inset_pitches * areaOf(surface) / std::max(length, 1e-9), least_inset * size, most_inset * size);
}

const ToolpathPoint&
pathPoint(const pcl::PointCloud<ToolpathPoint>& path, std::size_t index)
{
  return path[std::min(index, path.size() - 1)];
}

} // namespace pcl_spiral
