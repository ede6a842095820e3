// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.h"
#include "normal_error.h"
#include "ridge_display.h"

#include "box_axes.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/visualization/ridge_picture.h>

#include <vtkProperty.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Boxes = std::vector<std::array<Vector2d, 2>>;

constexpr double least_reach = 0.01; ///< degrees: machines do not hold less
constexpr Color true_color{0.05, 0.50, 0.15}, published_color{0.85, 0.05, 0.05}, edge_color{0.30, 0.33, 0.38}, band_color{0.55, 0.68, 0.85},
    most_color{0.10, 0.22, 0.66};

/** The upper end of colour scale and chart, degrees. */
double
reachOf(double largest)
{
  const double wanted = std::max(least_reach, largest), step = niceStep(0.1 * wanted);
  return step * std::ceil(wanted / step - 1e-9);
}

/** Both normals at the worst place, seen along the generator: the normal plane of the rail is upright there. */
void
addNormals(Canvas& canvas, const RidgeSurface& ridge, const NormalErrors& errors)
{
  const double across = 0.5 * ridge.generator().length();
  const Vector3d place = ridge.position(errors.u, errors.v), published = ridge.normal(errors.u, errors.v, RidgeNormals::InNormalPlane);
  const Vector3d along = ridge.frame(errors.u).tangent, towards = along.cross(published).normalized();
  const Inset inset = canvas.addInset(1, place + 0.25 * across * published, towards, across, published);
  Polyline row;
  for (int k = -50; k <= 50; ++k) {
    const double u = errors.u + 0.02 * across * k, end = ridge.rail().length();
    row.push_back(ridge.position(ridge.rail().closed() ? u : std::clamp(u, 0.0, end), errors.v));
  }
  inset.view->AddActor(lineActor({row}, false, edge_color, 3.0f));
  const auto add = [&](const Vector3d& normal, const Color& color, float width, double forward) {
    std::vector<Polyline> arrow;
    addArrow(arrow, place, 0.6 * across * normal, towards);
    const auto actor = lineActor(arrow, false, color, width);
    const Vector3d lift = forward * across * towards; // the view is parallel
    actor->SetPosition(lift.x(), lift.y(), lift.z());
    inset.view->AddActor(actor);
  };
  add(ridge.normal(errors.u, errors.v), true_color, 3.0f, 1.0);
  add(published, published_color, 2.0f, 2.0);
  addMark(inset.view, Marker::Circle, inset.onScreen(place), ink);
  addText(inset.view, "gray: the ridge along its rail", 10, Canvas::inset_size - 26, 16);
  addText(inset.view, "at the largest angle, along the generator", 10, 10, 16, true);
}

/** The angle over the generator: for each place from the smallest to the largest along the rail. */
class Chart {
public:
  Chart(vtkRenderer* view, const NormalErrors& errors) : view_(view), errors_(errors), reach_(reachOf(errors.largest)) {}

  void draw() const
  {
    Boxes band, most;
    for (double x = left; x < right; x += 1.0) {
      const double at = (x - left) / (right - left) * static_cast<double>(errors_.places.size() - 1);
      const double high = y(between(errors_.most, at));
      band.push_back({Vector2d(x, y(between(errors_.least, at))), Vector2d(x + 1.0, high)});
      most.push_back({Vector2d(x, high - 1.25), Vector2d(x + 1.0, high + 1.25)});
    }
    addBoxes(view_, band, band_color);
    addBoxes(view_, most, most_color);
    addScales();
  }

private:
  static constexpr double left = Sheet::words_left + 70.0, right = Sheet::width - 40.0, bottom = 490.0, top = 770.0; ///< pixels

  static double between(const std::vector<double>& values, double at)
  {
    const std::size_t k = std::min(static_cast<std::size_t>(at), values.size() - 2);
    const double share = at - static_cast<double>(k);
    return (1.0 - share) * values[k] + share * values[k + 1];
  }
  double y(double degrees) const { return bottom + (top - bottom) * degrees / reach_; }

  void addScales() const
  {
    Boxes strokes{{Vector2d(left, bottom), Vector2d(right, bottom)}, {Vector2d(left, bottom), Vector2d(left, top)}};
    const double step = niceStep(reach_ / 6.0), length = errors_.places.back(), along = niceStep(length / 6.0);
    for (double k = 0.0; k * step <= reach_ * (1.0 + 1e-9); k += 1.0) {
      strokes.push_back({Vector2d(left, y(k * step)), Vector2d(left - axis_tick_length, y(k * step))});
      addCentredText(view_, formatted("%.4g", k * step), {left - 40.0, y(k * step)}, 16);
    }
    for (double k = 0.0; k * along <= length * (1.0 + 1e-9); k += 1.0) {
      const double x = left + (right - left) * k * along / length;
      strokes.push_back({Vector2d(x, bottom), Vector2d(x, bottom - axis_tick_length)});
      addCentredText(view_, formatted("%.4g", k * along), {x, bottom - 24.0}, 16);
    }
    addStrokes(view_, strokes, ink, 1.5f);
    addText(view_, "angle, degrees: smallest to largest along the rail", Sheet::words_left, static_cast<int>(top) + 14, 17, true);
    addCentredText(view_, "length of the generator, mm", {0.5 * (left + right), bottom - 48.0}, 16);
  }

  vtkRenderer* view_;
  const NormalErrors& errors_;
  double reach_;
};

} // namespace

void
writeRidgeNormals(const std::string& file, const RidgeScene& scene)
{
  const DisplaySurface surface = ridgeDisplay(scene.ridge, [&scene](double u, double v) { return normalError(*scene.ridge, u, v); });
  const NormalErrors errors = normalErrors(*scene.ridge);
  Canvas canvas(surface);
  const auto colors = colorScale(0.0, reachOf(errors.largest));
  const auto ridge = coloredSurface(surface.mesh, colors);
  ridge->GetProperty()->SetAmbient(0.75); // the colours are more important than the shape
  ridge->GetProperty()->SetDiffuse(0.25);
  canvas.add(ridge);
  canvas.addAxes();
  canvas.addColorBar("error of the normal, degrees", colors);
  const Vector3d place = scene.ridge->position(errors.u, errors.v);
  const bool hidden = canvas.addCircle(place);
  canvas.addLegend({{formatted("largest, %.4g degrees", errors.largest) + (hidden ? ", hidden" : ""), ink, Marker::Circle},
                    {"true normal, dS/du x dS/dv", true_color},
                    {"published normal, r x N", published_color}});
  addText(canvas.view(), "at " + placeText(place) + " mm", Sheet::words_left, 890, 18);
  Chart(canvas.view(), errors).draw();
  addNormals(canvas, *scene.ridge, errors);
  canvas.addTitle(scene.title + ": error of the published normal",
                  formatted("up to %.3g degrees from the true normal", errors.largest) +
                      ": it stays in the rail's normal plane; where the frame twists, the true normal does not");
  canvas.save(file);
}

} // namespace pcl_spiral
