// SPDX-License-Identifier: BSD-3-Clause
#include "end_views.h"

#include "path_layer.h"

#include <vtkProperty.h>

namespace pcl_spiral {
namespace {

constexpr double view_pitches = 16.0; ///< across an enlarged view

} // namespace

void
addEndViews(Canvas& canvas, const pcl::PointCloud<ToolpathPoint>& path, double pitch, const std::string& turn, vtkScalarsToColors* colors)
{
  const double across = view_pitches * pitch, pixel = across / Canvas::inset_size;
  const double reach = across + longestMove(path);
  for (const int slot : {0, 1}) {
    const ToolpathPoint& end = slot == 0 ? path.front() : path.back();
    const Eigen::Vector3d centre = placeOf(end), normal = normalOf(end);
    const auto view = canvas.addInset(slot, centre, normal, across).view;
    view->AddActor(surfaceActor(surfaceNear(canvas.surface(), centre, across), surface_color));
    const auto lines = turnActor(path,
                                 pathLines(path, least_path_move * pixel,
                                           [&](const ToolpathPoint& point) {
                                             return (placeOf(point) - centre).norm() < reach && normalOf(point).dot(normal) > 0.0;
                                           }),
                                 colors);
    const Eigen::Vector3d lift = 2.0 * across * normal;
    lines->SetPosition(lift.x(), lift.y(), lift.z()); // above the surface; the view is parallel
    lines->GetProperty()->SetLineWidth(2.0f);
    view->AddActor(lines);
    addMark(view, Marker::Disc, Eigen::Vector2d::Constant(0.5 * Canvas::inset_size), slot == 0 ? path_start_color : path_end_color);
    addText(view, std::string(slot == 0 ? "start" : "end") + ", every " + turn + formatted(", %.3g mm across", across), 10, 10, 18, true);
  }
}

} // namespace pcl_spiral
