#include "canvas.h"

#include <pcl_spiral/visualization/shown_turns.h>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace pcl_spiral {
namespace {

constexpr double least_pitch = 4.0;    ///< pixels between drawn turns; nearer they run together
constexpr double least_move = 1.0;     ///< pixels between drawn points
constexpr double inset_pitches = 16.0; ///< across an enlarged view
constexpr Color start_color{0.10, 0.65, 0.20}, end_color{0.85, 0.05, 0.05};

Eigen::Vector3d
placeOf(const ToolpathPoint& point)
{
  return point.getVector3fMap().cast<double>();
}

Eigen::Vector3d
normalOf(const ToolpathPoint& point)
{
  return point.getNormalVector3fMap().cast<double>();
}

/** The stretches of the path for which \p shown is true, without the points nearer than \p least to the last
 * one, coloured by turn. */
template <typename Shown>
vtkSmartPointer<vtkActor>
pathActor(const pcl::PointCloud<ToolpathPoint>& path, double least, vtkScalarsToColors* colors, Shown shown)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> turns;
  vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> run;
  std::size_t last = 0;
  const auto add = [&](std::size_t i) {
    run.push_back(points->InsertNextPoint(placeOf(path[i]).data()));
    turns->InsertNextValue(path[i].turn);
    last = i;
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool inside = shown(path[i]);
    const bool ends = !run.empty() && (!inside || i + 1 == path.size());
    if (ends || (inside && (run.empty() || (placeOf(path[i]) - placeOf(path[last])).norm() >= least)))
      add(i); // a stretch reaches to the first point that is not shown
    if (ends) {
      lines->InsertNextCell(static_cast<vtkIdType>(run.size()), run.data());
      run.clear();
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->SetScalars(turns);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetLookupTable(colors);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

/** One end of the path enlarged, looking along its normal, with every turn. */
void
addInset(Canvas& canvas, int slot, const DisplaySurface& surface, const PictureScene& scene,
         vtkScalarsToColors* colors)
{
  const ToolpathPoint& end = slot == 0 ? scene.path->front() : scene.path->back();
  const Eigen::Vector3d centre = placeOf(end), normal = normalOf(end);
  const double pitch = 0.5 * (scene.report.smallest_step_over + scene.report.largest_step_over);
  const double across = inset_pitches * pitch, pixel = across / Canvas::inset_size;
  const auto view = canvas.addInset(slot, centre, normal, across).view;
  view->AddActor(surfaceActor(surfaceNear(surface, centre, across), surface_color));
  const auto path = pathActor(*scene.path, least_move * pixel, colors, [&](const ToolpathPoint& point) {
    return (placeOf(point) - centre).norm() < across && normalOf(point).dot(normal) > 0.0;
  });
  const Eigen::Vector3d lift = 2.0 * across * normal;
  path->SetPosition(lift.x(), lift.y(), lift.z()); // over the surface; the view is parallel
  path->GetProperty()->SetLineWidth(2.0f);
  view->AddActor(path);
  addMark(view, Marker::Disc, Eigen::Vector2d::Constant(0.5 * Canvas::inset_size),
          slot == 0 ? start_color : end_color);
  addText(view,
          text(slot == 0 ? "start, every turn, %.3g mm across" : "end, every turn, %.3g mm across", across),
          10, 10, 18, true);
}

LegendEntry
markEnd(Canvas& canvas, const ToolpathPoint& end, const std::string& name, const Color& color)
{
  const bool hidden = canvas.addMarker(placeOf(end), color);
  return {name + (hidden ? ", hidden by the part" : ""), color, hidden ? Marker::Ring : Marker::Disc};
}

} // namespace

void
SpiralPictures::writeSpiral(const std::string& file) const
{
  const PictureScene& scene = scene_;
  const DisplaySurface& surface = *surface_;
  const SpiralReport& report = scene.report;
  Canvas canvas(surface);
  const ShownTurns turns = chooseTurns(*scene.path, canvas.projection(), least_pitch);
  const auto colors = colorScale(0.0, static_cast<double>(report.turns));
  canvas.view()->AddActor(surfaceActor(surface.mesh, surface_color));
  const auto path = pathActor(*scene.path, least_move * canvas.projection().mm_per_pixel, colors,
                              [&turns](const ToolpathPoint& point) { return turns.shows(point.turn); });
  path->GetProperty()->SetLineWidth(1.6f);
  canvas.addOver(path);
  canvas.addAxes();
  canvas.addColorBar("turn", "%.0f", colors);
  canvas.addLegend({{"spiral, " + turns.caption(), {0.128, 0.567, 0.551}},
                    markEnd(canvas, scene.path->front(), "start", start_color),
                    markEnd(canvas, scene.path->back(), "end", end_color)});
  for (const int slot : {0, 1})
    addInset(canvas, slot, surface, scene, colors);
  canvas.addTitle(
      scene.title + ": " + std::to_string(report.turns) + " turns, " +
          text("%.2f m", report.path_length / 1000.0),
      text("ball radius %g mm, scallop %g mm", scene.settings.tool_radius, scene.settings.scallop_height) +
          text(", step-over %.3g to %.3g mm", report.smallest_step_over, report.largest_step_over));
  canvas.save(file);
}

} // namespace pcl_spiral
