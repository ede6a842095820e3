// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Many lines in one actor of VTK. Header only: the program that includes it links VTK.
 */
#pragma once

#include <pcl_spiral/visualization/impl/loop_color.h>

#include <Eigen/Core>

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <vector>

namespace pcl_spiral {

/** Lines collected as cells of one vtkPolyData, with a colour at every point. */
class ColoredLines {
public:
  ColoredLines()
  {
    points_->SetDataTypeToDouble();
    colors_->SetNumberOfComponents(3);
    colors_->SetName("Colors");
  }

  /** Adds a point to the current line. A point that is not finite is left out: the line goes on to the next point. */
  void add(const Eigen::Vector3d& place, const Color& color)
  {
    if (!place.allFinite())
      return;
    run_.push_back(points_->InsertNextPoint(place.data()));
    for (const double share : color)
      colors_->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * share)));
  }

  /** Ends the current line; a closed line goes back to its start. A line of a single point is not drawn. */
  void end(bool closed)
  {
    if (closed && run_.size() > 2)
      run_.push_back(run_.front());
    if (run_.size() > 1)
      lines_->InsertNextCell(static_cast<vtkIdType>(run_.size()), run_.data());
    run_.clear();
  }

  /** Whether there are no lines. */
  bool empty() const { return lines_->GetNumberOfCells() == 0; }

  /** The finished lines. */
  vtkSmartPointer<vtkPolyData> data() const
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points_);
    data->SetLines(lines_);
    data->GetPointData()->SetScalars(colors_);
    return data;
  }

private:
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> lines_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
  std::vector<vtkIdType> run_;
};

} // namespace pcl_spiral
