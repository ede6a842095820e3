// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.h"
#include "end_views.h"
#include "keep_out_layer.h"
#include "path_layer.h"

namespace pcl_spiral {

void
SpiralPictures::writeSpiral(const std::string& file) const
{
  const PictureScene& scene = scene_;
  const SpiralReport& report = scene.report;
  Canvas canvas(*surface_);
  const ShownTurns turns = chooseTurns(*scene.path, canvas.projection(), least_turn_pitch);
  const auto colors = colorScale(0.0, static_cast<double>(report.turns));
  std::vector<LegendEntry> legend{addSpiral(canvas, *scene.path, turns, colors)};
  addOverGaps(canvas, *scene.path, turns, legend);
  addKeepOuts(canvas, scene, legend);
  canvas.addAxes();
  canvas.addColorBar("turn", colors);
  for (const LegendEntry& end : markEnds(canvas, *scene.path))
    legend.push_back(end);
  canvas.addLegend(legend);
  addEndViews(canvas, *scene.path, 0.5 * (report.smallest_step_over + report.largest_step_over), "turn", colors);
  canvas.addTitle(scene.title + ": " + std::to_string(report.turns) + " turns, " + formatted("%.2f m", report.path_length / 1000.0),
                  formatted("ball radius %g mm, scallop %g mm", scene.settings.tool_radius, scene.settings.scallop_height) +
                      (report.smallest_step_over < report.largest_step_over
                           ? formatted(", step-over %.3g to %.3g mm", report.smallest_step_over, report.largest_step_over)
                           : formatted(", mean step-over %.3g mm", report.largest_step_over)));
  canvas.save(file);
}

} // namespace pcl_spiral
