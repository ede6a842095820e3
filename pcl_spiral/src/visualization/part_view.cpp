// SPDX-License-Identifier: BSD-3-Clause
#include "part_view.h"

#include <pcl_spiral/core/impl/angles.h>

#include <vtkLight.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double tilt = 35.0 * pi / 180.0;

} // namespace

void
addLight(vtkRenderer* view)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.35, 0.45, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  view->AddLight(light);
}

void
PartView::aim(const Eigen::Vector2d& room, const Eigen::Vector2d& middle)
{
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d outward = surface_.outward.isZero() ? z : surface_.outward;
  const bool is_flat = std::abs(outward.z()) > 0.5; // seen from the front, otherwise from above
  Eigen::Vector3d side = is_flat ? Eigen::Vector3d(-y) : z;
  side -= side.dot(outward) * outward;
  side = side.norm() > 0.3 ? side.normalized() : (x - x.dot(outward) * outward).normalized();
  const Eigen::Vector3d towards = std::cos(tilt) * outward + std::sin(tilt) * side;
  const Eigen::Vector3d right = (is_flat ? outward : z).cross(towards).normalized();
  projection_ = {right, towards.cross(right), 1.0};

  const Eigen::Vector3d half = 0.5 * (surface_.high - surface_.low);
  const double half_width = half.dot(right.cwiseAbs()), half_height = half.dot(projection_.top.cwiseAbs());
  projection_.mm_per_pixel = std::max(2.0 * half_width / room.x(), 2.0 * half_height / room.y());
  origin_ = middle - projection_.project(0.5 * (surface_.low + surface_.high));
}

Eigen::Vector2d
PartView::onScreen(const Eigen::Vector3d& place) const
{
  return origin_ + projection_.project(place);
}

bool
PartView::addMarker(const Eigen::Vector3d& place, const Color& color)
{
  const bool hidden = hides(surface_, place, projection_.towards());
  addMarkAt(hidden ? Marker::Ring : Marker::Disc, place, color);
  return hidden;
}

bool
PartView::addCircle(const Eigen::Vector3d& place, const Color& color)
{
  addMarkAt(Marker::Circle, place, color);
  return hides(surface_, place, projection_.towards());
}

Eigen::AlignedBox2d
PartView::axisWords() const
{
  Eigen::AlignedBox2d box;
  for (const BoxAxis& axis : layOutAxes(surface_.low, surface_.high, projection_))
    for (const AxisText& text : axis.texts)
      box.extend(Eigen::AlignedBox2d(origin_ + text.middle - text.half_size, origin_ + text.middle + text.half_size));
  return box;
}

void
PartView::drawAxes(vtkRenderer* view) const
{
  std::vector<std::array<Eigen::Vector2d, 2>> strokes;
  for (const BoxAxis& axis : layOutAxes(surface_.low, surface_.high, projection_)) {
    strokes.push_back({origin_ + axis.from, origin_ + axis.to});
    for (const Eigen::Vector2d& tick : axis.ticks)
      strokes.push_back({origin_ + tick, origin_ + tick + axis_tick_length * axis.outward});
    for (const AxisText& text : axis.texts)
      addCentredText(view, text.words, origin_ + text.middle, text.font_size);
  }
  addStrokes(view, strokes, ink, 1.5f);
}

} // namespace pcl_spiral
