// SPDX-License-Identifier: BSD-3-Clause
#include "worst_cells.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int cell = 2; ///< pixels

} // namespace

WorstCells::WorstCells(int width, int height)
: columns_((width + cell - 1) / cell), rows_((height + cell - 1) / cell), values_(static_cast<std::size_t>(columns_) * rows_),
  ranks_(values_.size(), -1.0f)
{}

void
WorstCells::put(const Eigen::Vector2d& place, double radius, float value, float rank)
{
  const Eigen::Vector2d at = place / cell;
  const double r = radius / cell;
  const auto limits = [r](double middle, int count) {
    return std::pair(std::max(0, static_cast<int>(std::floor(middle - r))), std::min(count - 1, static_cast<int>(std::floor(middle + r))));
  };
  const auto [first_x, last_x] = limits(at.x(), columns_);
  const auto [first_y, last_y] = limits(at.y(), rows_);
  const int own_x = static_cast<int>(std::floor(at.x())), own_y = static_cast<int>(std::floor(at.y()));
  for (int y = first_y; y <= last_y; ++y)
    for (int x = first_x; x <= last_x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * columns_ + x;
      const bool covers = (x == own_x && y == own_y) || std::hypot(x + 0.5 - at.x(), y + 0.5 - at.y()) <= r;
      if (!covers || rank <= ranks_[i])
        continue;
      values_[i] = value;
      ranks_[i] = rank;
    }
}

void
WorstCells::addTo(vtkRenderer* view, const std::function<Color(float)>& color) const
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> squares;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * columns_ + x;
      if (ranks_[i] < 0.0f)
        continue;
      vtkIdType corners[4];
      for (const int k : {0, 1, 2, 3})
        corners[k] = points->InsertNextPoint(cell * (x + (k == 1 || k == 2)), cell * (y + (k > 1)), 0.0);
      squares->InsertNextCell(4, corners);
      for (const double part : color(values_[i]))
        colors->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * part)));
    }
  vtkNew<vtkPolyData> shape;
  shape->SetPoints(points);
  shape->SetPolys(squares);
  shape->GetCellData()->SetScalars(colors);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shape);
  mapper->SetScalarModeToUseCellData();
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  view->AddActor(actor);
}

} // namespace pcl_spiral
