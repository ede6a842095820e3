// SPDX-License-Identifier: BSD-3-Clause
#include "canvas.h"

#include <vtkCamera.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int inset_bottom = 20, inset_apart = 16;
constexpr double side_margin = 152.0, top_margin = 130.0,
                 bottom_margin = 90.0; ///< pixels, for axes and text
constexpr double title_height = 100.0; ///< pixels
constexpr int most_rounds = 4;         ///< of making the part smaller until the numbers of its axes fit, too

} // namespace

Canvas::Canvas(const DisplaySurface& surface) : PartView(surface)
{
  addLight(view_);
  const Eigen::Vector2d middle = aimWithAxes();
  const Eigen::Vector3d centre = 0.5 * (surface_.low + surface_.high), towards = projection_.towards();
  const double size = 2.0 * (0.5 * (surface_.high - surface_.low)).norm();
  const Eigen::Vector3d eye = centre + 3.0 * size * towards;
  vtkCamera* const camera = view_->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(centre.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(projection_.top.data());
  camera->SetParallelScale(0.5 * height * projection_.mm_per_pixel);
  camera->SetWindowCenter(1.0 - 2.0 * middle.x() / width, 1.0 - 2.0 * middle.y() / height);
  camera->SetClippingRange(size, 5.0 * size);
}

Eigen::Vector2d
Canvas::aimWithAxes()
{
  const Eigen::AlignedBox2d page(Eigen::Vector2d::Zero(), Eigen::Vector2d(words_left, height - title_height));
  Eigen::AlignedBox2d room(Eigen::Vector2d(side_margin, bottom_margin), Eigen::Vector2d(words_left - side_margin, height - top_margin));
  for (int round = 0;; ++round) {
    aim(room.sizes(), room.center());
    const Eigen::AlignedBox2d words = axisWords();
    if (words.isEmpty() || page.contains(words) || round == most_rounds)
      return room.center();
    room.min() += (page.min() - words.min()).cwiseMax(0.0);
    room.max() -= (words.max() - page.max()).cwiseMax(0.0);
  }
}

void
Canvas::add(vtkActor* actor)
{
  view_->AddActor(actor);
}

void
Canvas::addOver(vtkActor* actor)
{
  // The view is parallel, so this changes nothing on the screen.
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

void
Canvas::addMarkAt(Marker marker, const Eigen::Vector3d& place, const Color& color)
{
  addMark(view_, marker, onScreen(place), color);
}

void
Canvas::addAxes()
{
  drawAxes(view_);
}

Inset
Canvas::addInset(int slot, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double across)
{
  const Eigen::Vector3d up = std::abs(normal.dot(projection_.top)) < 0.9 ? projection_.top : projection_.towards();
  return addInset(slot, centre, normal, across, up);
}

Inset
Canvas::addInset(int slot, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double across, const Eigen::Vector3d& up)
{
  auto view = vtkSmartPointer<vtkRenderer>::New();
  const double bottom = inset_bottom + (1 - slot) * (inset_size + inset_apart);
  view->SetViewport(words_left / double(width), bottom / height, (words_left + inset_size) / double(width), (bottom + inset_size) / height);
  view->SetBackground(0.97, 0.97, 0.97);
  window_->AddRenderer(view);
  addLight(view);
  const Eigen::Vector3d eye = centre + 10.0 * across * normal;
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
