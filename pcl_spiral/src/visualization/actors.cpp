// SPDX-License-Identifier: BSD-3-Clause
#include "actors.h"

#include <vtkCellArray.h>
#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace pcl_spiral {
namespace {

vtkSmartPointer<vtkScalarsToColors>
scaleOf(const std::array<Color, 5>& steps, double low, double high)
{
  auto colors = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (std::size_t i = 0; i < steps.size(); ++i)
    colors->AddRGBPoint(low + (high - low) * static_cast<double>(i) / 4.0, steps[i][0], steps[i][1], steps[i][2]);
  return colors;
}

} // namespace

vtkSmartPointer<vtkActor>
surfaceActor(vtkPolyData* surface, const Color& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetAmbient(0.4);
  actor->GetProperty()->SetDiffuse(0.6);
  actor->GetProperty()->SetSpecular(0.0);
  return actor;
}

vtkSmartPointer<vtkActor>
coloredSurface(vtkPolyData* surface, vtkScalarsToColors* colors)
{
  const auto actor = surfaceActor(surface, surface_color);
  actor->GetMapper()->ScalarVisibilityOn();
  actor->GetMapper()->SetLookupTable(colors);
  actor->GetMapper()->UseLookupTableScalarRangeOn();
  actor->GetMapper()->InterpolateScalarsBeforeMappingOn(); // large faces also get the colours of the scale
  return actor;
}

vtkSmartPointer<vtkActor>
lineActor(const std::vector<Polyline>& lines, bool closed, const Color& color, float width)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Polyline& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size() + (closed && !line.empty())));
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Eigen::Vector3d& p : line)
      cells->InsertCellPoint(points->InsertNextPoint(p.data()));
    if (closed && !line.empty())
      cells->InsertCellPoint(first);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkScalarsToColors>
colorScale(double low, double high)
{
  // steps of viridis (van der Walt and Smith 2015) without its bright end, which does not show on a light
  // surface
  return scaleOf({{{0.267, 0.005, 0.329}, {0.230, 0.322, 0.546}, middle_color, {0.369, 0.789, 0.383}, {0.640, 0.790, 0.100}}}, low, high);
}

vtkSmartPointer<vtkScalarsToColors>
divergingScale(double reach)
{
  return scaleOf({{{0.10, 0.22, 0.66}, {0.36, 0.66, 0.90}, {0.98, 0.96, 0.76}, {0.97, 0.62, 0.26}, {0.72, 0.05, 0.08}}}, -reach, reach);
}

} // namespace pcl_spiral
