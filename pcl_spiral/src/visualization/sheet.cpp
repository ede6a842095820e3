// SPDX-License-Identifier: BSD-3-Clause
#include "sheet.h"

#include "common/readable_text.h"
#include "fitted_text.h"
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/visualization/pictures.h>

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr int bar_height = 90, bar_margin = 15, legend_below = 140; ///< pixels
constexpr int label_size = 18, label_gap = 8, label_edge = 6;

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

/** Where bytes are no text, as a file's name may be, VTK 9.1 draws no word and VTK 9.3 throws. Their font has no
 *  sign for U+FFFD. */
std::string
drawable(const std::string& text)
{
  return readableText(text, "?");
}

/** The size of the font in which the numbers of a colour bar overlap neither one another nor the page's edge. */
int
labelSize(vtkRenderer* view, vtkScalarsToColors* colors, const std::string& format)
{
  const double* const range = colors->GetRange();
  const double apart = (PageSize::column_width - 2.0 * bar_margin) / 4.0 - label_gap;
  const double beyond = PageSize::column_room - PageSize::column_width + bar_margin - label_edge; // the last is centred on the bar's end
  int size = label_size;
  for (int k = 0; k < 5; ++k) {
    vtkNew<vtkTextActor> label;
    label->SetInput(formatted(format.c_str(), range[0] + 0.25 * k * (range[1] - range[0])).c_str());
    style(label->GetTextProperty(), size);
    fitText(label, view, k < 4 ? apart : std::min(apart, 2.0 * beyond));
    size = label->GetTextProperty()->GetFontSize();
  }
  return size;
}

/** Decimals that tell the five labels of a colour bar apart, and one more. */
std::string
labelFormat(vtkScalarsToColors* colors)
{
  const double* const range = colors->GetRange();
  const double apart = (range[1] - range[0]) / 4.0;
  const int decimals = apart > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(apart))), 0, 9) : 0;
  return "%." + std::to_string(decimals) + "f";
}

} // namespace

Sheet::Sheet() : window_(vtkSmartPointer<vtkRenderWindow>::New()), view_(vtkSmartPointer<vtkRenderer>::New())
{
  const std::string problem = displayProblem();
  if (!problem.empty())
    throw std::runtime_error(problem);
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(4);
  window_->SetSize(width, height);
  view_->SetBackground(1.0, 1.0, 1.0);
  window_->AddRenderer(view_);
}

void
Sheet::addTitle(const std::string& first, const std::string& second)
{
  pcl_spiral::addTitle(view_, PageSize(), first, second);
}

void
Sheet::addLegend(const std::vector<LegendEntry>& entries)
{
  pcl_spiral::addLegend(view_, PageSize(), entries);
}

void
Sheet::addColorBar(const std::string& title, vtkScalarsToColors* colors)
{
  pcl_spiral::addColorBar(view_, PageSize(), title, colors);
}

void
Sheet::save(const std::string& file)
{
  window_->Render();
  writePNG(window_, file);
}

void
addTitle(vtkRenderer* view, const PageSize& page, const std::string& first, const std::string& second)
{
  addText(view, first, 30, page.height - 50, 30, true);
  addText(view, second, 30, page.height - 88, 21);
}

int
addLegend(vtkRenderer* view, const PageSize& page, const std::vector<LegendEntry>& entries)
{
  int y = page.column_top - legend_below;
  for (const LegendEntry& entry : entries) {
    addMark(view, entry.marker, Eigen::Vector2d(page.wordsLeft() + 8.0, y + 8.0), entry.color);
    addText(view, entry.text, page.wordsLeft() + 28, y - 2, 20);
    y -= 30;
  }
  return y;
}

void
addColorBar(vtkRenderer* view, const PageSize& page, const std::string& title, vtkScalarsToColors* colors)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colors);
  bar->SetTitle((title + "\n").c_str());
  bar->SetNumberOfLabels(5);
  const std::string format = labelFormat(colors);
  bar->SetLabelFormat(format.c_str());
  bar->UnconstrainedFontSizeOn();
  style(bar->GetTitleTextProperty(), 20);
  style(bar->GetLabelTextProperty(), labelSize(view, colors, format));
  bar->SetOrientationToHorizontal();
  bar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  bar->SetPosition((page.wordsLeft() + bar_margin) / double(page.width), (page.column_top - bar_height) / double(page.height));
  bar->SetWidth((PageSize::column_width - 2.0 * bar_margin) / double(page.width));
  bar->SetHeight(bar_height / double(page.height));
  view->AddActor(bar);
}

void
writePNG(vtkRenderWindow* window, const std::string& file)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
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
    throw FileError(file, Diagnostic("cannot be written: ", std::string(std::strerror(errno))));
}

void
addText(vtkRenderer* view, const std::string& text, int x, int y, int size, bool bold)
{
  vtkNew<vtkTextActor> actor;
  actor->GetTextProperty()->SetBackgroundColor(view->GetBackground());
  actor->GetTextProperty()->SetBackgroundOpacity(0.85);
  actor->SetInput(drawable(text).c_str());
  actor->SetPosition(x, y);
  style(actor->GetTextProperty(), size, bold);
  fitText(actor, view, roomRightOf(x, view));
  view->AddActor(actor);
}

void
addCentredText(vtkRenderer* view, const std::string& text, const Eigen::Vector2d& middle, int size, double room)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(drawable(text).c_str());
  actor->SetPosition(middle.x(), middle.y());
  style(actor->GetTextProperty(), size);
  actor->GetTextProperty()->SetJustificationToCentered();
  actor->GetTextProperty()->SetVerticalJustificationToCentered();
  if (std::isfinite(room))
    fitText(actor, view, room);
  view->AddActor(actor);
}

} // namespace pcl_spiral
