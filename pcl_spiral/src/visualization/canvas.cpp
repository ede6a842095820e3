#include "canvas.h"

#include <pcl_spiral/io/file_error.h>

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace pcl_spiral {
namespace {

constexpr double tilt = 35.0 * M_PI / 180.0;
constexpr int main_right = 1190; ///< pixels; words and enlarged view stand right of it
constexpr int words_left = 1190, bar_bottom = 1040, bar_height = 90, bar_margin = 15, legend_top = 990;
constexpr int inset_bottom = 20, inset_apart = 16;
constexpr double side_margin = 136.0, top_margin = 130.0,
                 bottom_margin = 90.0; ///< pixels, for axes and words

void
style(vtkTextProperty* text, int size, bool bold = false)
{
  text->SetFontFamilyToArial();
  text->SetFontSize(size);
  text->SetColor(ink[0], ink[1], ink[2]);
  text->SetBold(bold);
  text->SetItalic(false);
  text->SetShadow(false);
}

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

Canvas::Canvas(const DisplaySurface& surface)
    : surface_(surface), window_(vtkSmartPointer<vtkRenderWindow>::New()),
      view_(vtkSmartPointer<vtkRenderer>::New())
{
  const std::string problem = displayProblem();
  if (!problem.empty())
    throw std::runtime_error(problem);
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(4);
  window_->SetSize(width, height);
  view_->SetBackground(1.0, 1.0, 1.0);
  window_->AddRenderer(view_);
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
  const double room_x = main_right - 2.0 * side_margin, room_y = height - top_margin - bottom_margin;
  projection_.mm_per_pixel = std::max(2.0 * half_width / room_x, 2.0 * half_height / room_y);
  const double middle_x = 0.5 * main_right, middle_y = bottom_margin + 0.5 * room_y;
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
  const double lift = std::max(0.7 * surface_.spacing, 0.004 * (surface_.high - surface_.low).norm());
  const Eigen::Vector3d shift = lift * projection_.towards();
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

vtkSmartPointer<vtkRenderer>
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
  return view;
}

void
Canvas::addTitle(const std::string& first, const std::string& second)
{
  addText(view_, first, 30, height - 50, 30, true);
  addText(view_, second, 30, height - 88, 21);
}

void
Canvas::addLegend(const std::vector<LegendEntry>& entries)
{
  int y = legend_top;
  for (const LegendEntry& entry : entries) {
    addMark(view_, entry.marker, Eigen::Vector2d(words_left + 8.0, y + 8.0), entry.color);
    addText(view_, entry.text, words_left + 28, y - 2, 20);
    y -= 30;
  }
}

void
Canvas::addColorBar(const std::string& title, const char* format, vtkScalarsToColors* colors)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colors);
  bar->SetTitle((title + "\n").c_str());
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat(format);
  bar->UnconstrainedFontSizeOn();
  style(bar->GetTitleTextProperty(), 20);
  style(bar->GetLabelTextProperty(), 18);
  bar->SetOrientationToHorizontal();
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition((words_left + bar_margin) / double(width), bar_bottom / double(height));
  bar->SetWidth((inset_size - 2.0 * bar_margin) / double(width));
  bar->SetHeight(bar_height / double(height));
  view_->AddActor(bar);
}

void
Canvas::save(const std::string& file)
{
  window_->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window_);
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputConnection(image->GetOutputPort());
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
  out.close();
  if (!out)
    throw FileError(file, std::string("cannot be written: ") + std::strerror(errno));
}

void
addText(vtkRenderer* view, const std::string& text, int x, int y, int size, bool bold)
{
  vtkNew<vtkTextActor> actor;
  actor->GetTextProperty()->SetBackgroundColor(view->GetBackground());
  actor->GetTextProperty()->SetBackgroundOpacity(0.85);
  actor->SetInput(text.c_str());
  actor->SetPosition(x, y);
  style(actor->GetTextProperty(), size, bold);
  view->AddActor(actor);
}

void
addCentredText(vtkRenderer* view, const std::string& text, const Eigen::Vector2d& middle, int size)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.c_str());
  actor->SetPosition(middle.x(), middle.y());
  style(actor->GetTextProperty(), size);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  view->AddActor(actor);
}

} // namespace pcl_spiral
