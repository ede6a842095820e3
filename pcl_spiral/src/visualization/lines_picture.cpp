#include "canvas.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_lines = 150; ///< more would run together
constexpr Color outer_color{0.80, 0.11, 0.13}, inner_color{0.93, 0.48, 0.05}, gap_color{0.75, 0.15, 0.70};
constexpr Color line_color{0.05, 0.05, 0.08}, centre_color{0.10, 0.30, 0.90};

/** The cloud's points coloured by height, in a size that leaves gaps between them. */
vtkSmartPointer<vtkActor>
pointActor(const DisplaySurface& surface, vtkScalarsToColors* colors, double mm_per_pixel)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(surface.mesh);
  mapper->SetLookupTable(colors);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetRepresentationToPoints();
  actor->GetProperty()->SetPointSize(
      static_cast<float>(std::clamp(0.6 * surface.spacing / mm_per_pixel, 1.0, 6.0)));
  actor->GetProperty()->LightingOff();
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
addLoops(Canvas& canvas, const SpiralReport& report, std::vector<LegendEntry>& legend)
{
  const auto add = [&](LoopType type, const Color& color, const std::string& name) {
    const std::vector<Polyline> loops = curves(report, type);
    if (loops.empty())
      return;
    canvas.addOver(lineActor(loops, true, color, 4.0f));
    canvas.addInFront(lineActor(loops, true, color, 1.0f));
    double longest = 0.0;
    for (const Polyline& loop : loops)
      longest = std::max(longest, length(loop, true));
    legend.push_back({loops.size() == 1 ? name + text(", %.0f mm long", longest)
                                        : std::to_string(loops.size()) + " " + name + "s" +
                                              text(", the longest %.0f mm", longest),
                      color});
  };
  add(LoopType::Outer, outer_color, "outer rim");
  add(LoopType::Inner, inner_color, "inner loop");
  add(LoopType::ScanGap, gap_color, "scan gap");
}

void
addLines(Canvas& canvas, const SpiralReport& report, std::vector<LegendEntry>& legend)
{
  const std::size_t every = (report.radial_lines.size() + most_lines - 1) / most_lines;
  std::vector<Polyline> shown;
  for (std::size_t i = 0; i < report.radial_lines.size(); i += every)
    shown.push_back(report.radial_lines[i]);
  canvas.addOver(lineActor(shown, false, line_color, 1.3f));
  legend.push_back({std::to_string(report.radial_lines.size()) + " radial lines" +
                        (every > 1 ? ", one in " + std::to_string(every) + " drawn" : ""),
                    line_color});
}

} // namespace

void
SpiralPictures::writeLines(const std::string& file) const
{
  const PictureScene& scene = scene_;
  const DisplaySurface& surface = *surface_;
  Canvas canvas(surface);
  double range[2] = {0.0, 1.0};
  surface.mesh->GetScalarRange(range);
  const auto colors = colorScale(range[0], range[1]);
  canvas.view()->AddActor(surfaceActor(surface.mesh, surface_color));
  canvas.view()->AddActor(pointActor(surface, colors, canvas.projection().mm_per_pixel));
  std::vector<LegendEntry> legend;
  addLoops(canvas, scene.report, legend);
  addLines(canvas, scene.report, legend);
  if (scene.report.boundaries == 1) {
    const bool hidden = canvas.addMarker(scene.report.centre, centre_color);
    legend.push_back({"centre", centre_color, hidden ? Marker::Ring : Marker::Disc});
  }
  canvas.addAxes();
  canvas.addLegend(legend);
  canvas.addColorBar("height, mm", "%.4g", colors);
  canvas.addTitle(scene.title + ": boundaries and radial lines",
                  std::to_string(scene.report.used_points) + " points, spacing " +
                      text("%.3g mm", scene.report.spacing) + text(", noise %.2g mm", scene.report.noise));
  canvas.save(file);
}

} // namespace pcl_spiral
