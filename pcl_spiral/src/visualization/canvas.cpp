#include "canvas.h"

#include <pcl_spiral/io/file_error.h>

#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkLightKit.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
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
constexpr int main_right = 1180; ///< pixels; words and enlarged view stand right of it
constexpr int words_left = 1150, legend_top = 590;
constexpr double side_margin = 130.0, top_margin = 130.0,
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
  vtkNew<vtkLightKit> lights;
  lights->SetKeyLightIntensity(0.85);
  lights->AddLightsToRenderer(view_);
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
  right_ = (lying ? outward : z).cross(towards).normalized();
  top_ = towards.cross(right_);
  centre_ = 0.5 * (surface_.low + surface_.high);

  const Eigen::Vector3d half = 0.5 * (surface_.high - surface_.low);
  const double half_width = half.dot(right_.cwiseAbs()), half_height = half.dot(top_.cwiseAbs());
  const double room_x = main_right - 2.0 * side_margin, room_y = height - top_margin - bottom_margin;
  const double mm_per_pixel = std::max(2.0 * half_width / room_x, 2.0 * half_height / room_y);
  const double middle_x = 0.5 * main_right, middle_y = bottom_margin + 0.5 * room_y;

  const double size = 2.0 * half.norm();
  const Eigen::Vector3d eye = centre_ + 3.0 * size * towards;
  vtkCamera* const camera = view_->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(centre_.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(top_.data());
  camera->SetParallelScale(0.5 * height * mm_per_pixel);
  camera->SetWindowCenter(1.0 - 2.0 * middle_x / width, 1.0 - 2.0 * middle_y / height);
  camera->SetClippingRange(size, 5.0 * size);
}

double
Canvas::millimetresPerPixel() const
{
  return 2.0 * view_->GetActiveCamera()->GetParallelScale() / height;
}

Eigen::Vector2d
Canvas::onScreen(const Eigen::Vector3d& place) const
{
  return Eigen::Vector2d(right_.dot(place - centre_), top_.dot(place - centre_)) / millimetresPerPixel();
}

void
Canvas::addOver(vtkActor* actor)
{
  // The view is parallel, so this moves nothing on the screen.
  const double lift = std::max(0.7 * surface_.spacing, 0.004 * (surface_.high - surface_.low).norm());
  const Eigen::Vector3d shift = lift * right_.cross(top_);
  actor->SetPosition(shift.x(), shift.y(), shift.z());
  view_->AddActor(actor);
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
    vtkNew<vtkPlaneSource> swatch; // a square of 16 pixels
    swatch->SetOrigin(0.0, 0.0, 0.0);
    swatch->SetPoint1(16.0, 0.0, 0.0);
    swatch->SetPoint2(0.0, 16.0, 0.0);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputConnection(swatch->GetOutputPort());
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->SetPosition(words_left, y);
    actor->GetProperty()->SetColor(entry.color[0], entry.color[1], entry.color[2]);
    view_->AddActor(actor);
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
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition(0.92, 0.52);
  bar->SetWidth(0.06);
  bar->SetHeight(0.38);
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

} // namespace pcl_spiral
