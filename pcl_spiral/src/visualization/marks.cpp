// SPDX-License-Identifier: BSD-3-Clause
#include "sheet.h"

#include <pcl_spiral/core/impl/angles.h>

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int circle_corners = 32;
constexpr double mark_radius = 8.0, ring_hole = 4.5, square_half = 8.0, circle_radius = 11.0,
                 circle_line = 2.0; ///< pixels
constexpr double white_edge = 2.0;  ///< round a mark, so that it can be seen on lines

void
addFlat(vtkRenderer* view, vtkPolyData* shape, const Color& color, float line_width)
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(line_width);
  view->AddActor(actor);
}

/** The strip between two circles. */
void
addStrip(vtkRenderer* view, const Eigen::Vector2d& place, double inner, double outer, const Color& color)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  for (int i = 0; i < circle_corners; ++i) {
    const double angle = 2.0 * pi * i / circle_corners;
    for (const double r : {inner, outer})
      points->InsertNextPoint(place.x() + r * std::cos(angle), place.y() + r * std::sin(angle), 0.0);
    const vtkIdType at = 2 * i, next = 2 * ((i + 1) % circle_corners);
    const vtkIdType corners[4] = {at, at + 1, next + 1, next};
    polygons->InsertNextCell(4, corners);
  }
  vtkNew<vtkPolyData> strip;
  strip->SetPoints(points);
  strip->SetPolys(polygons);
  addFlat(view, strip, color, 1.0f);
}

} // namespace

void
addMark(vtkRenderer* view, Marker marker, const Eigen::Vector2d& place, const Color& color)
{
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(square_half);
  if (marker == Marker::Square)
    return addBoxes(view, {{place - half, place + half}}, color);
  if (marker == Marker::Circle) {
    addStrip(view, place, circle_radius - 0.5 * white_edge, circle_radius + circle_line + 0.5 * white_edge, {1.0, 1.0, 1.0});
    return addStrip(view, place, circle_radius, circle_radius + circle_line, color);
  }
  const double hole = marker == Marker::Ring ? ring_hole : 0.0;
  addStrip(view, place, std::max(0.0, hole - white_edge), mark_radius + white_edge, {1.0, 1.0, 1.0});
  addStrip(view, place, hole, mark_radius, color);
}

void
addBoxes(vtkRenderer* view, const std::vector<std::array<Eigen::Vector2d, 2>>& boxes, const Color& color)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polygons;
  for (const auto& [low, high] : boxes) {
    const vtkIdType corners[4] = {points->InsertNextPoint(low.x(), low.y(), 0.0), points->InsertNextPoint(high.x(), low.y(), 0.0),
                                  points->InsertNextPoint(high.x(), high.y(), 0.0), points->InsertNextPoint(low.x(), high.y(), 0.0)};
    polygons->InsertNextCell(4, corners);
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(polygons);
  addFlat(view, shape, color, 1.0f);
}

void
addStrokes(vtkRenderer* view, const std::vector<std::array<Eigen::Vector2d, 2>>& strokes, const Color& color, float width)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const auto& stroke : strokes) {
    vtkIdType ends[2];
    for (int i = 0; i < 2; ++i)
      ends[i] = points->InsertNextPoint(stroke[i].x(), stroke[i].y(), 0.0);
    lines->InsertNextCell(2, ends);
  }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetLines(lines);
  addFlat(view, shape, color, width);
}

} // namespace pcl_spiral
