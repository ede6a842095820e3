// SPDX-License-Identifier: BSD-3-Clause
#include "depth_map.h"
#include "ridge_display.h"
#include "value_actors.h"

#include <pcl_spiral/visualization/ridge_picture.h>

#include <vtkProperty.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr int frames = 25, curve_steps = 600;
constexpr std::array<double, 3> arrow_shares{0.45, 0.8,
                                             0.8}; ///< of the distance between neighbouring frames; the rail is visible between them
constexpr float thin = 1.0f, thick = 2.5f;         ///< pixels
constexpr double most_scan_points = 15000.0;
constexpr Color curve_color{0.05, 0.05, 0.08}, carried_color{0.45, 0.48, 0.53}, scan_color{0.62, 0.75, 0.86}, level_color{0.45, 0.47, 0.50},
    rail_color{0.95, 0.45, 0.00}, generator_color{0.75, 0.10, 0.70}, meeting_color{0.10, 0.10, 0.10};
constexpr std::array<Color, 3> frame_colors{{{0.85, 0.05, 0.05}, {0.05, 0.60, 0.15}, {0.10, 0.25, 0.90}}};

std::array<Vector3d, 3>
axesOf(const RidgeFrame& frame)
{
  return {frame.tangent, frame.chord, frame.up};
}

/** The frame at \p u for the drawing along the rail. */
std::array<Vector3d, 3>
arrowsAt(const RidgeSurface& ridge, double u)
{
  std::array<Vector3d, 3> arrows = axesOf(ridge.frame(u));
  for (int k = 0; k < 3; ++k)
    arrows[k] *= arrow_shares[k] * ridge.rail().length() / frames;
  return arrows;
}

/** Draws the ridge and everything on it. */
DisplaySurface
surfaceOf(const RidgeScene& scene)
{
  DisplaySurface surface = ridgeDisplay(scene.ridge, [](double, double) { return 0.0; });
  if (scene.rail.empty() || scene.generator.empty())
    throw std::invalid_argument("a picture of the lines of a ridge needs the measured points of the rail and of the generator");
  extend(surface, scene.rail);
  extend(surface, scene.generator);
  for (const double u : stationsAlong(scene.ridge->rail(), frames - 1))
    for (const Vector3d& arrow : arrowsAt(*scene.ridge, u))
      extend(surface, {scene.ridge->rail().position(u) + arrow});
  return surface;
}

/** The finite \p points, \p size pixels wide. */
vtkSmartPointer<vtkActor>
pointsActor(const pcl::PointCloud<pcl::PointXYZ>& points, const Color& color, float size)
{
  std::vector<std::uint32_t> shown;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (points[i].getVector3fMap().allFinite())
      shown.push_back(i);
  const ValueStyle plain{[](float) { return 0.0f; }, [&color](float) { return color; }, [](float) { return false; }};
  auto actor = valuePoints(points, shown, std::vector<float>(points.size(), 0.0f), plain);
  actor->GetProperty()->SetPointSize(size);
  return actor;
}

vtkSmartPointer<vtkActor>
pointsActor(const Polyline& line, const Color& color, float size)
{
  pcl::PointCloud<pcl::PointXYZ> points;
  for (const Vector3d& p : line)
    points.push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
  return pointsActor(points, color, size);
}

/** The scan round the ridge, thinned evenly. */
void
addScan(Canvas& canvas, const RidgeScene& scene, std::vector<LegendEntry>& legend)
{
  if (!scene.scan)
    return;
  const DisplaySurface& surface = canvas.surface();
  pcl::PointCloud<pcl::PointXYZ> inside, shown;
  for (const pcl::PointXYZ& point : *scene.scan)
    if (const Eigen::Array3d p = point.getArray3fMap().cast<double>();
        (p >= surface.low.array()).all() && (p <= surface.high.array()).all())
      inside.push_back(point);
  const auto every = static_cast<std::size_t>(std::ceil(std::max(1.0, static_cast<double>(inside.size()) / most_scan_points)));
  for (std::size_t i = 0; i < inside.size(); i += every)
    shown.push_back(inside[i]);
  canvas.add(pointsActor(shown, scan_color, 2.0f));
  legend.push_back({"scan" + (every > 1 ? ", one point in " + std::to_string(every) : std::string()), scan_color});
}

/** The frames along the rail: with thin lines where the ridge hides them. */
void
addFrames(Canvas& canvas, const RidgeSurface& ridge, std::vector<LegendEntry>& legend)
{
  const DepthMap depth(canvas.surface(), canvas);
  const std::vector<double> stations = stationsAlong(ridge.rail(), ridge.rail().closed() ? frames : frames - 1);
  std::vector<Polyline> carried;
  carried.reserve(stations.size());
  for (const double u : stations)
    carried.push_back(generatorAt(ridge, u));
  canvas.addOver(lineActor(carried, false, carried_color, thin));
  const std::array<std::string, 3> names{"m1, along the rail", "m2, along the chord", "m3, up"};
  for (int k = 2; k >= 0; --k) {
    std::vector<Polyline> seen, hidden;
    for (const double u : stations) {
      const Vector3d foot = ridge.rail().position(u);
      const std::array<Vector3d, 3> arrows = arrowsAt(ridge, u);
      const bool is_hidden = depth.hides(foot) && depth.hides(foot + arrows[2]); // at the outline of the ridge, not only its foot
      addArrow(is_hidden ? hidden : seen, foot, arrows[k], canvas.projection().towards());
    }
    canvas.addInFront(lineActor(seen, false, frame_colors[k], thick));
    canvas.addInFront(lineActor(hidden, false, frame_colors[k], thin));
  }
  for (int k = 0; k < 3; ++k)
    legend.push_back({names[k], frame_colors[k]});
  legend.push_back({"the generator, moved along", carried_color});
}

void
addLines(Canvas& canvas, const RidgeScene& scene, std::vector<LegendEntry>& legend)
{
  const RidgeSurface& ridge = *scene.ridge;
  const RidgeReport& report = ridge.report();
  canvas.addOver(pointsActor(scene.rail, rail_color, 6.0f));
  canvas.addOver(pointsActor(scene.generator, generator_color, 6.0f));
  Polyline rail;
  for (const double u : stationsAlong(ridge.rail(), curve_steps))
    rail.push_back(ridge.rail().position(u));
  canvas.addInFront(lineActor({rail}, report.closed, curve_color, thin));
  canvas.addInFront(lineActor({generatorAt(ridge, report.meeting)}, false, curve_color, thin));
  legend.push_back({"rail, " + std::to_string(report.rail_points) + " points measured", rail_color});
  legend.push_back({"generator, " + std::to_string(report.generator_points) + " points measured", generator_color});
  legend.push_back({"curves fitted to them", curve_color});
  const bool hidden = canvas.addMarker(report.meeting_place, meeting_color);
  legend.push_back({"where they meet" + std::string(hidden ? ", hidden" : ""), meeting_color, hidden ? Marker::Ring : Marker::Disc});
}

/** The generator in the normal plane of the rail where it was measured; the reference normal is up. */
void
addGenerator(Canvas& canvas, const RidgeScene& scene)
{
  const RidgeSurface& ridge = *scene.ridge;
  const double u = ridge.report().meeting;
  const RidgeFrame frame = ridge.frame(u);
  const Vector3d foot = ridge.rail().position(u);
  const Polyline curve = generatorAt(ridge, u);
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : curve)
    box.extend(frame.localOf(p - foot));
  const double arrow = 0.4 * box.extend(Vector3d::Zero()).sizes().maxCoeff();
  box.extend(Vector3d(0.0, arrow, 0.0)).extend(Vector3d(0.0, 0.0, arrow));
  const Vector3d towards = frame.tangent, centre = foot + frame.turned(box.center());
  const Vector3d reference = ridge.chord().reference, level = reference.cross(towards).normalized();
  const double across = 1.5 * box.sizes().maxCoeff();
  const Inset inset = canvas.addInset(1, centre, towards, across, reference);
  const auto add = [&](const vtkSmartPointer<vtkActor>& actor, int layer) {
    const Vector3d lift = layer * across * towards; // the view is parallel
    actor->SetPosition(lift.x(), lift.y(), lift.z());
    inset.view->AddActor(actor);
  };
  const Vector3d &start = curve.front(), &end = curve.back();
  add(lineActor({{start - 2.0 * across * level, start + 2.0 * across * level}}, false, level_color, thin), 0);
  add(lineActor({{start, end}}, false, curve_color, thin), 1);
  add(pointsActor(scene.generator, generator_color, 6.0f), 2);
  add(lineActor({curve}, false, curve_color, 1.5f), 3);
  for (const int k : {1, 2}) {
    std::vector<Polyline> lines;
    addArrow(lines, foot, arrow * axesOf(frame)[k], towards);
    add(lineActor(lines, false, frame_colors[k], thick), 4 + k);
  }
  addMark(inset.view, Marker::Disc, inset.onScreen(ridge.report().meeting_place), meeting_color);
  addText(inset.view, formatted("generator, seen along the rail; view %.3g mm", across), 10, 10, 16, true);
  addText(inset.view, "gray: parallel to the reference plane", 10, Canvas::inset_size - 26, 16);
  addText(inset.view, "black: its curve and its chord", 10, Canvas::inset_size - 50, 16);
}

/** Figures of the lines. */
void
addFigures(Canvas& canvas, const RidgeReport& report, int y)
{
  const std::vector<std::string> lines{formatted("chord %.4g mm, theta %.3f degrees", report.chord, report.chord_angle),
                                       formatted("rail %.5g mm, misfit of points %.4f mm rms", report.rail_length, report.rail_error),
                                       formatted("generator %.4g mm, misfit %.4f mm rms", report.generator_length, report.generator_error),
                                       formatted("where they meet: %.4f mm apart", report.meeting_distance),
                                       formatted("generator tilted by %.3f degrees there", report.tilt),
                                       formatted("rail's slope: up to %.2f degrees", report.largest_slope),
                                       formatted("its errors turn the chord %.2f times as much", report.slope_factor),
                                       formatted("stretch along the rail: from %.3f (0: it folds)", report.least_stretch)};
  for (const std::string& line : lines) {
    addText(canvas.view(), line, Canvas::words_left, y, 18);
    y -= 26;
  }
}

} // namespace

void
writeRidgeLines(const std::string& file, const RidgeScene& scene)
{
  const DisplaySurface surface = surfaceOf(scene);
  Canvas canvas(surface);
  std::vector<LegendEntry> legend;
  canvas.add(surfaceActor(surface.mesh, surface_color));
  addLines(canvas, scene, legend);
  addFrames(canvas, *scene.ridge, legend);
  addScan(canvas, scene, legend);
  canvas.addAxes();
  const int below = addLegend(canvas.view(), PageSize(), legend);
  addFigures(canvas, scene.ridge->report(), below - 12);
  addGenerator(canvas, scene);
  const RidgeReport& report = scene.ridge->report();
  canvas.addTitle(scene.title + ": rail, generator and frames",
                  "the generator keeps its shape in m1, m2, m3, and its chord the angle theta" +
                      std::string(report.closed ? "; the rail is closed" : ""));
  canvas.save(file);
}

} // namespace pcl_spiral
