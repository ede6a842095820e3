// SPDX-License-Identifier: BSD-3-Clause
#include "value_actors.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

namespace pcl_spiral {
namespace {

constexpr float outstanding_size = 6.0f; ///< pixels

vtkSmartPointer<vtkActor>
flatActor(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkUnsignedCharArray>
noColors()
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  return colors;
}

void
addColor(vtkUnsignedCharArray* colors, const Color& color)
{
  for (const double part : color)
    colors->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * part)));
}

/** One vertex per point. */
vtkSmartPointer<vtkPolyData>
vertices(vtkPoints* points)
{
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    cells->InsertNextCell(1, &i);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  return data;
}

} // namespace

vtkSmartPointer<vtkActor>
valueLines(const PathLines& lines, const std::vector<float>& values, const ValueStyle& style)
{
  const auto colors = noColors();
  for (const std::uint32_t i : lines.points)
    addColor(colors, style.color(values[i]));
  lines.data->GetPointData()->SetScalars(colors);
  return flatActor(lines.data);
}

vtkSmartPointer<vtkActor>
valuePoints(const pcl::PointCloud<pcl::PointXYZ>& points, const std::vector<std::uint32_t>& indices, const std::vector<float>& values,
            const ValueStyle& style)
{
  vtkNew<vtkPoints> places;
  const auto colors = noColors();
  for (const std::uint32_t i : indices) {
    places->InsertNextPoint(points[i].data);
    addColor(colors, style.color(values[i]));
  }
  const auto data = vertices(places);
  data->GetPointData()->SetScalars(colors);
  return flatActor(data);
}

template <typename PointT>
std::vector<vtkSmartPointer<vtkActor>>
outstandingPoints(const pcl::PointCloud<PointT>& points, const std::vector<float>& values, const ValueStyle& style)
{
  struct Group {
    float rank = 0.0f;
    vtkNew<vtkPoints> places;
  };
  std::map<Color, Group> groups;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isnan(values[i]) && style.outstanding(values[i]) && points[i].getVector3fMap().allFinite()) {
      Group& group = groups[style.color(values[i])];
      group.rank = std::max(group.rank, style.rank(values[i]));
      group.places->InsertNextPoint(points[i].data);
    }
  std::vector<std::pair<float, vtkSmartPointer<vtkActor>>> ranked;
  for (const auto& [color, group] : groups) {
    const auto actor = flatActor(vertices(group.places));
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
    actor->GetProperty()->SetPointSize(outstanding_size);
    ranked.emplace_back(group.rank, actor);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<vtkSmartPointer<vtkActor>> actors;
  actors.reserve(ranked.size());
  for (const auto& [rank, actor] : ranked)
    actors.push_back(actor);
  return actors;
}

template std::vector<vtkSmartPointer<vtkActor>> outstandingPoints(const pcl::PointCloud<pcl::PointXYZ>&, const std::vector<float>&,
                                                                  const ValueStyle&);
template std::vector<vtkSmartPointer<vtkActor>> outstandingPoints(const pcl::PointCloud<ToolpathPoint>&, const std::vector<float>&,
                                                                  const ValueStyle&);

} // namespace pcl_spiral
