// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_window.h"

#include "common/readable_text.h"
#include <pcl_spiral/visualization/pictures.h>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>

#include <algorithm>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr int widest = 1600, highest = 1200, title_height = 110, column_gap = 24; ///< pixels
constexpr double screen_share = 0.9;
constexpr double side_margin = 136.0, top_margin = 130.0,
                 bottom_margin = 170.0; ///< pixels, for axes and text
constexpr double axes_from = 0.4;       ///< of the scale of the whole part: with a nearer camera the axes are outside the view
constexpr double scale_room = 160.0;
constexpr Color lasso_color{0.80, 0.0, 0.55};
constexpr int scale_left = 30, scale_bottom = 76;

} // namespace

ViewerWindow::ViewerWindow(const DisplaySurface& surface, const std::string& name) : PartView(surface)
{
  const std::string problem = displayFault();
  if (!problem.empty())
    throw std::runtime_error("a window needs a display and " + problem);
  const int* const screen = window_->GetScreenSize();
  window_->SetSize(std::min(widest, static_cast<int>(screen_share * screen[0])),
                   std::min(highest, static_cast<int>(screen_share * screen[1])));
  window_->SetWindowName(readableText(name, "?").c_str());
  window_->SetMultiSamples(4);
  window_->SetNumberOfLayers(2);
  for (vtkRenderer* const renderer : {view_.Get(), side_.Get(), overlay_.Get(), words_.Get()}) {
    renderer->SetBackground(1.0, 1.0, 1.0);
    renderer->SetInteractive(renderer == view_.Get());
    renderer->SetLayer(renderer == overlay_.Get() || renderer == words_.Get());
    window_->AddRenderer(renderer);
  }
  addLight(view_);
  view_->GetActiveCamera()->ParallelProjectionOn();
  reset();
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(this);
  command->SetCallback([](vtkObject*, unsigned long, void* self, void*) { static_cast<ViewerWindow*>(self)->beforeFrame(); });
  observer_ = window_->AddObserver(vtkCommand::StartEvent, command);
}

ViewerWindow::~ViewerWindow()
{
  window_->RemoveObserver(observer_);
}

int
ViewerWindow::viewWidth() const
{
  return page_.wordsLeft() - column_gap;
}

double
ViewerWindow::size() const
{
  return (surface_.high - surface_.low).norm();
}

void
ViewerWindow::fitToWindow()
{
  page_.width = window_->GetSize()[0];
  page_.height = window_->GetSize()[1];
  page_.column_top = page_.height - title_height;
  const double split = std::max(0.1, viewWidth() / static_cast<double>(page_.width));
  for (vtkRenderer* const renderer : {view_.Get(), overlay_.Get()})
    renderer->SetViewport(0.0, 0.0, split, 1.0);
  side_->SetViewport(split, 0.0, 1.0, 1.0);
}

void
ViewerWindow::clear()
{
  before_.insert(before_.end(), actors_.begin(), actors_.end());
  actors_.clear();
  lifted_.clear();
  marks_.clear();
  measures_ = false;
  words_->RemoveAllViewProps();
}

void
ViewerWindow::add(vtkActor* actor)
{
  before_.erase(std::remove(before_.begin(), before_.end(), actor), before_.end());
  actors_.emplace_back(actor);
  view_->AddActor(actor); // does nothing if it is already there
}

void
ViewerWindow::addOver(vtkActor* actor)
{
  addOver(actor, 1);
}

void
ViewerWindow::addOver(vtkActor* actor, int layers)
{
  add(actor);
  lifted_.push_back({actor, layers * clearance(surface_)});
}

void
ViewerWindow::addInFront(vtkActor* actor)
{
  add(actor);
  lifted_.push_back({actor, size()});
}

void
ViewerWindow::addMarkAt(Marker marker, const Eigen::Vector3d& place, const Color& color)
{
  marks_.push_back({marker, place, color});
}

void
ViewerWindow::addMeasures()
{
  measures_ = true;
}

void
ViewerWindow::reset()
{
  fitToWindow();
  const Eigen::Vector2d window(viewWidth(), page_.height);
  const Eigen::Vector2d room(std::max(50.0, window.x() - 2.0 * side_margin), std::max(50.0, window.y() - top_margin - bottom_margin));
  aim(room, 0.5 * window);
  whole_scale_ = projection_.mm_per_pixel;
  const double up = 0.5 * (top_margin - bottom_margin) * whole_scale_; // the middle of the free area is not the middle of the window
  const Eigen::Vector3d middle = 0.5 * (surface_.low + surface_.high) + up * projection_.top;
  const Eigen::Vector3d eye = middle + 3.0 * size() * projection_.towards();
  vtkCamera* const camera = view_->GetActiveCamera();
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(projection_.top.data());
  camera->SetParallelScale(0.5 * page_.height * projection_.mm_per_pixel);
  readCamera();
}

void
ViewerWindow::lookAt(const Eigen::Vector3d& place, const Eigen::Vector3d& normal, double across)
{
  readCamera();
  const Eigen::Vector3d up = std::abs(normal.dot(projection_.top)) < 0.9 ? projection_.top : projection_.towards();
  const Eigen::Vector3d eye = place + 3.0 * size() * normal;
  vtkCamera* const camera = view_->GetActiveCamera();
  camera->SetFocalPoint(place.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(up.data());
  const double least = std::min(viewWidth(), page_.height);
  camera->SetParallelScale(0.5 * across * page_.height / std::max(least, 50.0));
  readCamera();
}

void
ViewerWindow::lookDown()
{
  reset();
  const Eigen::Vector3d middle = 0.5 * (surface_.low + surface_.high), eye = middle + 3.0 * size() * Eigen::Vector3d::UnitZ();
  vtkCamera* const camera = view_->GetActiveCamera();
  camera->SetFocalPoint(middle.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(0.0, 1.0, 0.0);
  const Eigen::Vector3d room = surface_.high - surface_.low;
  const double pixel = std::max(room.x() / std::max(50.0, viewWidth() - 2.0 * side_margin),
                                room.y() / std::max(50.0, page_.height - top_margin - bottom_margin));
  camera->SetParallelScale(0.5 * page_.height * pixel);
  readCamera();
}

void
ViewerWindow::widen(double times)
{
  vtkCamera* const camera = view_->GetActiveCamera();
  camera->SetParallelScale(times * camera->GetParallelScale());
  readCamera();
}

Eigen::Vector3d
ViewerWindow::placeAt(const Eigen::Vector2d& pixel) const
{
  const Eigen::Vector2d at = projection_.mm_per_pixel * (pixel - origin_);
  const Eigen::Vector3d middle = 0.5 * (surface_.low + surface_.high), towards = projection_.towards();
  return at.x() * projection_.right + at.y() * projection_.top + middle.dot(towards) * towards;
}

void
ViewerWindow::readCamera()
{
  vtkCamera* const camera = view_->GetActiveCamera();
  const Eigen::Vector3d towards = -Eigen::Map<const Eigen::Vector3d>(camera->GetDirectionOfProjection());
  Eigen::Vector3d top = Eigen::Map<const Eigen::Vector3d>(camera->GetViewUp());
  top = (top - top.dot(towards) * towards).normalized();
  projection_ = {top.cross(towards), top, 2.0 * camera->GetParallelScale() / page_.height};
  origin_ =
      0.5 * Eigen::Vector2d(viewWidth(), page_.height) - projection_.project(Eigen::Map<const Eigen::Vector3d>(camera->GetFocalPoint()));
}

bool
ViewerWindow::isNear(const Eigen::Vector3d& place) const
{
  const Eigen::Vector2d at = onScreen(place), window(viewWidth(), page_.height);
  return (at.array() > -0.5 * window.array()).all() && (at.array() < 1.5 * window.array()).all();
}

void
ViewerWindow::beforeFrame()
{
  if (window_->GetSize()[0] != page_.width || window_->GetSize()[1] != page_.height) {
    fitToWindow();
    readCamera();
    if (resized_)
      resized_();
  }
  readCamera();
  for (const auto& actor : before_)
    view_->RemoveActor(actor);
  before_.clear();
  for (const Lifted& lifted : lifted_) {
    // The view is parallel, so this changes nothing on the screen.
    const Eigen::Vector3d shift = lifted.by * projection_.towards();
    lifted.actor->SetPosition(shift.x(), shift.y(), shift.z());
  }
  view_->GetActiveCamera()->SetClippingRange(0.5 * size(), 5.5 * size());
  overlay_->RemoveAllViewProps();
  if (measures_)
    drawScale();
  if (measures_ && projection_.mm_per_pixel > axes_from * whole_scale_)
    drawAxes(overlay_);
  for (const Mark& mark : marks_)
    addMark(overlay_, mark.marker, onScreen(mark.place), mark.color);
  drawLasso();
}

void
ViewerWindow::drawLasso()
{
  std::vector<std::array<Eigen::Vector2d, 2>> strokes;
  for (std::size_t i = 0; i < lasso_.size(); ++i)
    strokes.push_back({lasso_[i], lasso_[(i + 1) % lasso_.size()]});
  if (!strokes.empty())
    addStrokes(overlay_, strokes, lasso_color, 2.0f);
}

void
ViewerWindow::drawScale()
{
  const double length = niceStep(0.4 * scale_room * projection_.mm_per_pixel);
  const Eigen::Vector2d left(scale_left, scale_bottom), tick(0.0, 5.0);
  const Eigen::Vector2d right = left + Eigen::Vector2d(length / projection_.mm_per_pixel, 0.0);
  addStrokes(overlay_, {{left, right}, {left - tick, left + tick}, {right - tick, right + tick}}, ink, 2.0f);
  addText(overlay_, formatted("%g mm", length), static_cast<int>(right.x()) + 12, scale_bottom - 6, 18);
}

void
ViewerWindow::render()
{
  window_->Render();
}

} // namespace pcl_spiral
