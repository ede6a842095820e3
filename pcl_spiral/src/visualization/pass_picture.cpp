// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/visualization/pass_picture.h>

#include "end_views.h"
#include "path_layer.h"
#include "shown_passes.h"

#include <pcl_spiral/common/point_types.h>

#include <algorithm>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr double beyond = 0.25;     ///< of the path's size: margin of the scan shown around it
constexpr double lone_pitch = 0.01; ///< of the part's size, if no pass has a neighbour
constexpr Color lift_color{0.45, 0.47, 0.50};

std::string
counted(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string
cutterInWords(const CutterShape& cutter)
{
  if (!(cutter.radius > 0.0))
    return "a beam";
  const bool ball = cutter.flank_angle == 0.0 && cutter.corner_radius == cutter.radius;
  return ball ? formatted("ball radius %g mm", cutter.radius)
              : formatted("tool radius %g mm, corner radius %g mm", cutter.radius, cutter.corner_radius) +
                    (cutter.flank_angle != 0.0 ? formatted(", flank angle %g degrees", cutter.flank_angle) : "");
}

DisplaySurface
surfaceOf(const PassScene& scene)
{
  if (!(scene.cloud || scene.mesh) || !scene.path || scene.path->empty())
    throw std::invalid_argument("a picture of passes needs the part (a cloud or a mesh) and the path");
  PictureScene part;
  part.cloud = scene.cloud;
  part.mesh = scene.mesh;
  part.path = scene.path;
  return displaySurface(part, beyond);
}

} // namespace

void
writePasses(const std::string& file, const PassScene& scene)
{
  const DisplaySurface surface = surfaceOf(scene);
  const pcl::PointCloud<ToolpathPoint>& path = *scene.path;
  Canvas canvas(surface);
  const ShownPasses shown = choosePasses(path, canvas, DepthMap(surface, canvas), least_turn_pitch);
  const std::size_t count = shown.shown.size();
  const bool turns = count > 1 && passBegins(path).empty(); // one pass with several turns
  const std::string turn = turns ? "turn" : "pass";
  const auto colors = colorScale(0.0, static_cast<double>(turns ? count : std::max<std::size_t>(count, 2) - 1));
  addPath(
      canvas, path, [&shown](double at) { return shown.shows(at); }, colors);
  canvas.addAxes();
  if (count > 1)
    canvas.addColorBar(turn, colors);
  std::vector<LegendEntry> legend{{shown.caption(turn), middle_color}};
  if (count > 1 && !turns)
    legend.push_back({counted(count - 1, "lift", "lifts") + " between, not drawn", lift_color});
  for (const LegendEntry& end : markEnds(canvas, path))
    legend.push_back(end);
  canvas.addLegend(legend);
  const double size = (surface.high - surface.low).norm();
  addEndViews(canvas, path, scene.step_over > 0.0 ? scene.step_over : lone_pitch * size, turn, colors);
  canvas.addTitle(scene.title + ": " + (turns ? "1 pass, " + std::to_string(count) + " turns" : counted(count, "pass", "passes")) +
                      formatted(", %.2f m", (path.back().arc_length - path.front().arc_length) / 1000.0),
                  cutterInWords(scene.cutter) + (scene.step_over > 0.0 ? formatted(", step-over %.3g mm", scene.step_over) : ""));
  canvas.save(file);
}

} // namespace pcl_spiral
