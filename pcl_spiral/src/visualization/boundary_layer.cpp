// SPDX-License-Identifier: BSD-3-Clause
#include "boundary_layer.h"

#include "actors.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_lines = 150; ///< more lines are too close together
constexpr Color line_color{0.05, 0.05, 0.08}, finger_color{0.80, 0.10, 0.45}, centre_color{0.10, 0.30, 0.90};

/** The points of the cloud coloured by height, small enough for gaps between them. */
vtkSmartPointer<vtkActor>
pointActor(const DisplaySurface& surface, vtkScalarsToColors* colors, double mm_per_pixel)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface.mesh);
  mapper->SetLookupTable(colors);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetRepresentationToPoints();
  actor->GetProperty()->SetPointSize(static_cast<float>(std::clamp(0.6 * surface.spacing / mm_per_pixel, 1.0, 6.0)));
  return actor;
}

std::vector<Polyline>
curves(const SpiralReport& report, LoopType type)
{
  std::vector<Polyline> result;
  for (const BoundaryLoop& loop : report.loops)
    if (loop.type == type)
      result.push_back(loop.curve.empty() ? loop.points : loop.curve);
  return result;
}

void
addLoops(PartView& view, const SpiralReport& report, std::vector<LegendEntry>& legend)
{
  const auto add = [&](LoopType type, const std::string& name) {
    const Color color = loopColor(type);
    const std::vector<Polyline> loops = curves(report, type);
    if (loops.empty())
      return;
    view.addOver(lineActor(loops, true, color, 4.0f));
    view.addInFront(lineActor(loops, true, color, 1.0f));
    double longest = 0.0;
    for (const Polyline& loop : loops)
      longest = std::max(longest, length(loop, true));
    legend.push_back({loops.size() == 1 ? name + formatted(", %.0f mm long", longest)
                                        : std::to_string(loops.size()) + " " + name + "s" + formatted(", the longest %.0f mm", longest),
                      color});
  };
  add(LoopType::Outer, "outer rim");
  add(LoopType::Inner, "inner loop");
  add(LoopType::ScanGap, "scan gap");
}

void
addLines(PartView& view, const SpiralReport& report, std::vector<LegendEntry>& legend)
{
  if (report.radial_lines.empty())
    return;
  const std::size_t every = (report.radial_lines.size() + most_lines - 1) / most_lines;
  std::vector<Polyline> shown;
  for (std::size_t i = 0; i < report.radial_lines.size(); i += every)
    shown.push_back(report.radial_lines[i]);
  view.addOver(lineActor(shown, false, line_color, 1.3f));
  legend.push_back(
      {std::to_string(report.radial_lines.size()) + " radial lines" + (every > 1 ? ", one in " + std::to_string(every) + " drawn" : ""),
       line_color});
}

/** Loops at constant scallop height, and the middles of their fingers. */
void
addScallopLines(PartView& view, const SpiralReport& report, std::vector<LegendEntry>& legend)
{
  if (report.scallop_lines.empty())
    return;
  const std::size_t every = (report.scallop_lines.size() + most_lines - 1) / most_lines;
  std::vector<Polyline> shown;
  for (std::size_t i = 0; i < report.scallop_lines.size(); i += every)
    shown.push_back(report.scallop_lines[i]);
  view.addOver(lineActor(shown, true, line_color, 1.3f));
  legend.push_back(
      {std::to_string(report.scallop_lines.size()) + " loops" + (every > 1 ? ", one in " + std::to_string(every) + " drawn" : ""),
       line_color});
  if (report.finger_axes.empty())
    return;
  view.addOver(lineActor(report.finger_axes, false, finger_color, 2.0f));
  legend.push_back({"middles of " + std::to_string(report.finger_axes.size()) + " fingers, where ridges are", finger_color});
}

} // namespace

vtkSmartPointer<vtkScalarsToColors>
heightColors(const DisplaySurface& surface)
{
  double range[2] = {0.0, 1.0};
  surface.mesh->GetScalarRange(range);
  return colorScale(range[0], range[1]);
}

std::vector<LegendEntry>
addBoundaries(PartView& view, const SpiralReport& report, vtkScalarsToColors* height_colors)
{
  if (view.surface().of_mesh)
    view.add(coloredSurface(view.surface().mesh, height_colors));
  else {
    view.add(surfaceActor(view.surface().mesh, surface_color));
    view.add(pointActor(view.surface(), height_colors, view.projection().mm_per_pixel));
  }
  std::vector<LegendEntry> legend;
  addLoops(view, report, legend);
  addLines(view, report, legend);
  addScallopLines(view, report, legend);
  if (report.boundaries == 1 && report.method != SpiralMethod::ConstantScallop) {
    const bool hidden = view.addMarker(report.centre, centre_color);
    legend.push_back({"centre", centre_color, hidden ? Marker::Ring : Marker::Disc});
  }
  return legend;
}

std::string
boundariesTitle(const PictureScene& scene)
{
  const SpiralReport& report = scene.report;
  return scene.title + (!report.radial_lines.empty()    ? ": boundaries and radial lines"
                        : !report.scallop_lines.empty() ? ": boundaries, loops and fingers"
                        : scene.mesh                    ? ": the mesh and its boundaries"
                        : scene.path->empty()           ? ": the scan"
                                                        : ": the scan and its boundaries");
}

std::string
partInWords(const PictureScene& scene)
{
  if (scene.mesh)
    return std::to_string(scene.mesh->faceCount()) + " faces, " + std::to_string(scene.mesh->vertexCount()) + " vertices";
  const SpiralReport& report = scene.report;
  if (scene.path->empty())
    return std::to_string(scene.cloud->size()) + " points";
  return std::to_string(report.used_points) + " points, spacing " + formatted("%.3g mm", report.spacing) +
         formatted(", noise %.2g mm", report.noise);
}

} // namespace pcl_spiral
