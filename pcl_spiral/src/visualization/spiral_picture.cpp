#include "canvas.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pcl_spiral {
namespace {

constexpr double least_pitch = 5.0;    ///< pixels between drawn turns; nearer they run together
constexpr double inset_pitches = 16.0; ///< across the enlarged view
constexpr Color start_color{0.10, 0.65, 0.20}, end_color{0.85, 0.05, 0.05};

/** The path, or every so manyth turn of it, coloured by turn and lifted off the surface by \p lift. */
vtkSmartPointer<vtkActor>
pathActor(const pcl::PointCloud<ToolpathPoint>& path, int every, double lift, vtkScalarsToColors* colors,
          float width)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> turns;
  vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> run;
  const auto finish = [&] {
    if (run.size() > 1)
      lines->InsertNextCell(static_cast<vtkIdType>(run.size()), run.data());
    run.clear();
  };
  for (const ToolpathPoint& point : path) {
    const bool shown = static_cast<int>(point.turn) % every == 0;
    if (!shown && run.empty())
      continue;
    const Eigen::Vector3d p =
        point.getVector3fMap().cast<double>() + lift * point.getNormalVector3fMap().cast<double>();
    run.push_back(points->InsertNextPoint(p.data()));
    turns->InsertNextValue(point.turn);
    if (!shown) // a turn drawn alone ends where the next begins
      finish();
  }
  finish();
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->SetScalars(turns);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetLookupTable(colors);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->LightingOff();
  return actor;
}

std::string
text(const char* format, double a, double b)
{
  char result[160];
  std::snprintf(result, sizeof(result), format, a, b);
  return result;
}

double
meanPitch(const SpiralReport& report)
{
  return 0.5 * (report.smallest_step_over + report.largest_step_over);
}

/** The path's innermost end enlarged, looking along its normal. */
void
addInset(Canvas& canvas, const DisplaySurface& surface, const PictureScene& scene, vtkScalarsToColors* colors)
{
  const bool outward = scene.settings.direction == SpiralDirection::Outward;
  const ToolpathPoint& end = outward ? scene.path->front() : scene.path->back();
  const Eigen::Vector3d centre =
      scene.report.boundaries == 1 ? scene.report.centre : end.getVector3fMap().cast<double>().eval();
  const Eigen::Vector3d normal = end.getNormalVector3fMap().cast<double>();
  const double across = inset_pitches * meanPitch(scene.report);

  vtkNew<vtkRenderer> view;
  view->SetViewport(0.70, 0.02, 0.985, 0.40);
  view->SetBackground(0.97, 0.97, 0.97);
  canvas.window()->AddRenderer(view);
  vtkNew<vtkLightKit> lights;
  lights->AddLightsToRenderer(view);
  view->AddActor(surfaceActor(surface, surface_color));
  view->AddActor(pathActor(*scene.path, 1, 0.02 * across, colors, 2.0f));

  vtkCamera* const camera = view->GetActiveCamera();
  const Eigen::Vector3d eye = centre + across * normal;
  const Eigen::Vector3d up = std::abs(normal.y()) < 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(up.data());
  camera->SetParallelScale(0.5 * across);
  camera->SetClippingRange(0.01 * across, 3.0 * across);
  addText(view,
          text(scene.report.boundaries == 1 ? "centre, %.3g mm across" : "inner edge, %.3g mm across", across,
               0.0),
          12, 12, 20, true);
}

} // namespace

void
SpiralPictures::writeSpiral(const std::string& file) const
{
  const PictureScene& scene = scene_;
  const DisplaySurface& surface = *surface_;
  const SpiralReport& report = scene.report;
  Canvas canvas(surface);
  const double pixel = canvas.millimetresPerPixel();
  const int every =
      std::max(1, static_cast<int>(std::ceil(least_pitch * pixel / std::max(meanPitch(report), 1e-9))));
  const auto colors = colorScale(0.0, static_cast<double>(report.turns));
  canvas.view()->AddActor(surfaceActor(surface, surface_color));
  canvas.addOver(pathActor(*scene.path, every, 0.0, colors, 1.6f));
  const auto place = [](const ToolpathPoint& point) { return point.getVector3fMap().cast<double>().eval(); };
  canvas.addOver(ballActor(place(scene.path->front()), 6.0 * pixel, start_color));
  canvas.addOver(ballActor(place(scene.path->back()), 6.0 * pixel, end_color));
  canvas.addAxes();
  canvas.addLegend({{every > 1 ? "spiral, one turn in " + std::to_string(every) + " drawn" : "spiral",
                     {0.128, 0.567, 0.551}},
                    {"start", start_color},
                    {"end", end_color}});
  canvas.addColorBar("turn", "%.0f", colors);
  addInset(canvas, surface, scene, colors);
  canvas.addTitle(
      scene.title + ": " + std::to_string(report.turns) + " turns, " +
          text("%.2f m", report.path_length / 1000.0, 0.0),
      text("ball radius %g mm, scallop %g mm", scene.settings.tool_radius, scene.settings.scallop_height) +
          text(", step-over %.3g to %.3g mm", report.smallest_step_over, report.largest_step_over));
  canvas.save(file);
}

} // namespace pcl_spiral
