#include "canvas.h"
#include "path_layer.h"

#include <vtkProperty.h>

namespace pcl_spiral {
namespace {

constexpr double inset_pitches = 16.0; ///< across an enlarged view

/** One end of the path enlarged, looking along its normal, with every turn. */
void
addInset(Canvas& canvas, int slot, const DisplaySurface& surface, const PictureScene& scene,
         vtkScalarsToColors* colors)
{
  const ToolpathPoint& end = slot == 0 ? scene.path->front() : scene.path->back();
  const Eigen::Vector3d centre = placeOf(end), normal = normalOf(end);
  const double pitch = 0.5 * (scene.report.smallest_step_over + scene.report.largest_step_over);
  const double across = inset_pitches * pitch, pixel = across / Canvas::inset_size;
  const double reach = across + longestMove(*scene.path);
  const auto view = canvas.addInset(slot, centre, normal, across).view;
  view->AddActor(surfaceActor(surfaceNear(surface, centre, across), surface_color));
  const auto path = turnActor(*scene.path,
                              pathLines(*scene.path, least_path_move * pixel,
                                        [&](const ToolpathPoint& point) {
                                          return (placeOf(point) - centre).norm() < reach &&
                                                 normalOf(point).dot(normal) > 0.0;
                                        }),
                              colors);
  const Eigen::Vector3d lift = 2.0 * across * normal;
  path->SetPosition(lift.x(), lift.y(), lift.z()); // over the surface; the view is parallel
  path->GetProperty()->SetLineWidth(2.0f);
  view->AddActor(path);
  addMark(view, Marker::Disc, Eigen::Vector2d::Constant(0.5 * Canvas::inset_size),
          slot == 0 ? path_start_color : path_end_color);
  addText(view,
          text(slot == 0 ? "start, every turn, %.3g mm across" : "end, every turn, %.3g mm across", across),
          10, 10, 18, true);
}

} // namespace

void
SpiralPictures::writeSpiral(const std::string& file) const
{
  const PictureScene& scene = scene_;
  const DisplaySurface& surface = *surface_;
  const SpiralReport& report = scene.report;
  Canvas canvas(surface);
  const ShownTurns turns = chooseTurns(*scene.path, canvas.projection(), least_turn_pitch);
  const auto colors = colorScale(0.0, static_cast<double>(report.turns));
  std::vector<LegendEntry> legend{addSpiral(canvas, *scene.path, turns, colors)};
  addOverGaps(canvas, *scene.path, turns, legend);
  canvas.addAxes();
  canvas.addColorBar("turn", colors);
  for (const LegendEntry& end : markEnds(canvas, *scene.path))
    legend.push_back(end);
  canvas.addLegend(legend);
  for (const int slot : {0, 1})
    addInset(canvas, slot, surface, scene, colors);
  canvas.addTitle(
      scene.title + ": " + std::to_string(report.turns) + " turns, " +
          text("%.2f m", report.path_length / 1000.0),
      text("ball radius %g mm, scallop %g mm", scene.settings.tool_radius, scene.settings.scallop_height) +
          (report.smallest_step_over < report.largest_step_over
               ? text(", step-over %.3g to %.3g mm", report.smallest_step_over, report.largest_step_over)
               : text(", mean step-over %.3g mm", report.largest_step_over)));
  canvas.save(file);
}

} // namespace pcl_spiral
