// SPDX-License-Identifier: BSD-3-Clause
#include "path_layer.h"

#include "actors.h"

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cstdint>

namespace pcl_spiral {
namespace {

LegendEntry
markEnd(PartView& view, const ToolpathPoint& end, const std::string& name, const Color& color)
{
  const bool hidden = view.addMarker(placeOf(end), color);
  return {name + (hidden ? ", hidden by the part" : ""), color, hidden ? Marker::Ring : Marker::Disc};
}

} // namespace

double
longestMove(const pcl::PointCloud<ToolpathPoint>& path)
{
  double longest = 0.0;
  const std::vector<std::size_t> passes = passBegins(path);
  for (std::size_t i = 1; i < path.size(); ++i)
    if (!beginsPass(passes, i))
      longest = std::max(longest, (placeOf(path[i]) - placeOf(path[i - 1])).norm());
  return longest;
}

PathLines
pathLines(const pcl::PointCloud<ToolpathPoint>& path, double least, const std::function<bool(const ToolpathPoint&)>& shown)
{
  PathLines result{vtkSmartPointer<vtkPolyData>::New(), {}};
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> run;
  const std::vector<std::size_t> passes = passBegins(path);
  std::size_t last = 0;
  const auto add = [&](std::size_t i) {
    run.push_back(points->InsertNextPoint(placeOf(path[i]).data()));
    result.points.push_back(static_cast<std::uint32_t>(i));
    last = i;
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (beginsPass(passes, i))
      run.clear(); // of a single point
    const bool inside = shown(path[i]);
    const bool ends = !run.empty() && (!inside || i + 1 == path.size() || beginsPass(passes, i + 1));
    if (ends || (inside && (run.empty() || (placeOf(path[i]) - placeOf(path[last])).norm() >= least)))
      add(i); // a run ends at the first point that is not shown
    if (ends) {
      lines->InsertNextCell(static_cast<vtkIdType>(run.size()), run.data());
      run.clear();
    }
  }
  result.data->SetPoints(points);
  result.data->SetLines(lines);
  return result;
}

vtkSmartPointer<vtkActor>
turnActor(const pcl::PointCloud<ToolpathPoint>& path, const PathLines& lines, vtkScalarsToColors* colors)
{
  vtkNew<vtkDoubleArray> turns;
  for (const std::uint32_t i : lines.points)
    turns->InsertNextValue(path[i].turn);
  lines.data->GetPointData()->SetScalars(turns);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines.data);
  mapper->SetLookupTable(colors);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

void
addPath(PartView& view, const pcl::PointCloud<ToolpathPoint>& path, const std::function<bool(double)>& shows, vtkScalarsToColors* colors)
{
  view.add(surfaceActor(view.surface().mesh, surface_color));
  const auto lines = turnActor(path,
                               pathLines(path, least_path_move * view.projection().mm_per_pixel,
                                         [&](const ToolpathPoint& point) { return shows(point.turn) && view.isNear(placeOf(point)); }),
                               colors);
  lines->GetProperty()->SetLineWidth(1.6f);
  view.addOver(lines);
}

LegendEntry
addSpiral(PartView& view, const pcl::PointCloud<ToolpathPoint>& path, const ShownTurns& turns, vtkScalarsToColors* colors)
{
  addPath(
      view, path, [&turns](double turn) { return turns.shows(turn); }, colors);
  return {"spiral, " + turns.caption(), middle_color};
}

void
addOverGaps(PartView& view, const pcl::PointCloud<ToolpathPoint>& path, const ShownTurns& turns, std::vector<LegendEntry>& legend)
{
  const PathLines lines = pathLines(path, least_path_move * view.projection().mm_per_pixel, [&](const ToolpathPoint& point) {
    return point.over_gap != 0 && turns.shows(point.turn) && view.isNear(placeOf(point));
  });
  if (lines.points.empty())
    return;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(lines.data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(over_gap_color[0], over_gap_color[1], over_gap_color[2]);
  actor->GetProperty()->SetLineWidth(3.0f);
  view.addOver(actor);
  legend.push_back({"over bridged gaps of the scan", over_gap_color});
}

std::vector<LegendEntry>
markEnds(PartView& view, const pcl::PointCloud<ToolpathPoint>& path)
{
  return {markEnd(view, path.front(), "start", path_start_color), markEnd(view, path.back(), "end", path_end_color)};
}

} // namespace pcl_spiral
