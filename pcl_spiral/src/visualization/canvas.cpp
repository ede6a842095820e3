#include "canvas.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double tilt = 35.0 * M_PI / 180.0;
constexpr int inset_bottom = 20, inset_apart = 16;
constexpr double side_margin = 136.0, top_margin = 130.0,
                 bottom_margin = 90.0; ///< pixels, for axes and words

/** From over the viewer's left shoulder. */
void
addLight(vtkRenderer* view)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.35, 0.45, 1.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  view->AddLight(light);
}

} // namespace

Canvas::Canvas(const DisplaySurface& surface) : surface_(surface)
{
  addLight(view_);
  aim();
}

void
Canvas::aim()
{
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d outward = surface_.outward.isZero() ? z : surface_.outward;
  const bool lying = std::abs(outward.z()) > 0.5; // seen from the front, else from above
  Eigen::Vector3d side = lying ? Eigen::Vector3d(-y) : z;
  side -= side.dot(outward) * outward;
  side = side.norm() > 0.3 ? side.normalized() : (x - x.dot(outward) * outward).normalized();
  const Eigen::Vector3d towards = std::cos(tilt) * outward + std::sin(tilt) * side;
  const Eigen::Vector3d right = (lying ? outward : z).cross(towards).normalized();
  projection_ = {right, towards.cross(right), 1.0};
  const Eigen::Vector3d centre = 0.5 * (surface_.low + surface_.high);

  const Eigen::Vector3d half = 0.5 * (surface_.high - surface_.low);
  const double half_width = half.dot(right.cwiseAbs()), half_height = half.dot(projection_.top.cwiseAbs());
  const double room_x = words_left - 2.0 * side_margin, room_y = height - top_margin - bottom_margin;
  projection_.mm_per_pixel = std::max(2.0 * half_width / room_x, 2.0 * half_height / room_y);
  const double middle_x = 0.5 * words_left, middle_y = bottom_margin + 0.5 * room_y;
  origin_ = Eigen::Vector2d(middle_x, middle_y) - projection_.project(centre);

  const double size = 2.0 * half.norm();
  const Eigen::Vector3d eye = centre + 3.0 * size * towards;
  vtkCamera* const camera = view_->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(projection_.top.data());
  camera->SetParallelScale(0.5 * height * projection_.mm_per_pixel);
  camera->SetWindowCenter(1.0 - 2.0 * middle_x / width, 1.0 - 2.0 * middle_y / height);
  camera->SetClippingRange(size, 5.0 * size);
}

Eigen::Vector2d
Canvas::onScreen(const Eigen::Vector3d& place) const
{
  return origin_ + projection_.project(place);
}

void
Canvas::addOver(vtkActor* actor)
{
  // The view is parallel, so this moves nothing on the screen.
  const Eigen::Vector3d shift = clearance(surface_) * projection_.towards();
  actor->SetPosition(shift.x(), shift.y(), shift.z());
  view_->AddActor(actor);
}

void
Canvas::addInFront(vtkActor* actor)
{
  const Eigen::Vector3d shift = (surface_.high - surface_.low).norm() * projection_.towards();
  actor->SetPosition(shift.x(), shift.y(), shift.z());
  view_->AddActor(actor);
}

bool
Canvas::addMarker(const Eigen::Vector3d& place, const Color& color)
{
  const bool hidden = hides(surface_, place, projection_.towards());
  addMark(view_, hidden ? Marker::Ring : Marker::Disc, onScreen(place), color);
  return hidden;
}

bool
Canvas::addCircle(const Eigen::Vector3d& place)
{
  addMark(view_, Marker::Circle, onScreen(place), ink);
  return hides(surface_, place, projection_.towards());
}

void
Canvas::addAxes()
{
  std::vector<std::array<Eigen::Vector2d, 2>> strokes;
  for (const BoxAxis& axis : layOutAxes(surface_.low, surface_.high, projection_)) {
    strokes.push_back({origin_ + axis.from, origin_ + axis.to});
    for (const Eigen::Vector2d& tick : axis.ticks)
      strokes.push_back({origin_ + tick, origin_ + tick + axis_tick_length * axis.outward});
    for (const AxisText& text : axis.texts)
      addCentredText(view_, text.words, origin_ + text.middle, text.font_size);
  }
  addStrokes(view_, strokes, ink, 1.5f);
}

Inset
Canvas::addInset(int slot, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double across)
{
  auto view = vtkSmartPointer<vtkRenderer>::New();
  const double bottom = inset_bottom + (1 - slot) * (inset_size + inset_apart);
  view->SetViewport(words_left / double(width), bottom / height, (words_left + inset_size) / double(width),
                    (bottom + inset_size) / height);
  view->SetBackground(0.97, 0.97, 0.97);
  window_->AddRenderer(view);
  addLight(view);
  const Eigen::Vector3d eye = centre + 10.0 * across * normal;
  const Eigen::Vector3d up =
      std::abs(normal.dot(projection_.top)) < 0.9 ? projection_.top : projection_.towards();
  vtkCamera* const camera = view->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(up.data());
  camera->SetParallelScale(0.5 * across);
  camera->SetClippingRange(0.1 * across, 20.0 * across);
  const Eigen::Vector3d right = up.cross(normal).normalized();
  Inset inset{view, {right, normal.cross(right).normalized(), across / inset_size}, {}};
  inset.origin = Eigen::Vector2d::Constant(0.5 * inset_size) - inset.projection.project(centre);
  return inset;
}

} // namespace pcl_spiral
